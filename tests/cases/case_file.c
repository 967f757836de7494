#include "case_file.h"

#include <stdlib.h>
#include <string.h>

#include "fields.h"

int is(const char* word, const char* other) { return strcmp(word, other) == 0; }

void malformed(const Statement* statement, const char* what) {
  fprintf(stderr, "line %d: %s\n", statement->line, what);
  exit(2);
}

int next_statement(FILE* file, Statement* statement) {
  while (fgets(statement->text, sizeof statement->text, file)) {
    char *comment, *word;
    ++statement->line;
    if (!strchr(statement->text, '\n') && !feof(file)) malformed(statement, "more characters than allowed");
    comment = strchr(statement->text, '#');
    if (comment) *comment = '\0';
    statement->text[strcspn(statement->text, "\r\n")] = '\0';
    strcpy(statement->rest, statement->text);
    statement->count = 0;
    for (word = strtok(statement->text, " \t"); word; word = strtok(NULL, " \t")) {
      if (statement->count == MOST_WORDS) malformed(statement, "more words than allowed");
      statement->words[statement->count++] = word;
    }
    if (statement->count > 2)
      memmove(statement->rest, statement->rest + (statement->words[2] - statement->text),
              strlen(statement->rest + (statement->words[2] - statement->text)) + 1);
    if (statement->count > 0) return 1;
  }
  return 0;
}

const char* word_at(const Statement* statement, int i) {
  if (i >= statement->count) malformed(statement, "too few words");
  return statement->words[i];
}

double number_at(const Statement* statement, int i) {
  const char* word = word_at(statement, i);
  char* end = NULL;
  double number;
  const Constant* constant;
  for (constant = case_constants; constant->name; ++constant)
    if (is(word, constant->name)) return constant->value;
  number = strtod(word, &end);
  if (end == word || *end != '\0') malformed(statement, "a number or a constant is expected");
  return number;
}

int numbers_from(const Statement* statement, int first, double* numbers, int most) {
  int count = statement->count - first, i;
  if (count > most) malformed(statement, "too many numbers");
  for (i = 0; i < count; ++i) numbers[i] = number_at(statement, first + i);
  return count;
}
