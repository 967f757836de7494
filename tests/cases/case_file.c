#include "case_file.h"

#include <halfspace/halfspace.h>
#include <stdlib.h>
#include <string.h>

typedef struct Constant {
  const char* name;
  int32_t value;
} Constant;

#define STATUS_CONSTANT(name, value, text) {#name, value},
#define CONSTANT(name) \
  { #name, name }

static const Constant constants[] = {
    HS_STATUS_LIST(STATUS_CONSTANT) CONSTANT(HS_CONTACT_NONE),
    CONSTANT(HS_CONTACT_VERTEX_VERTEX),
    CONSTANT(HS_CONTACT_VERTEX_EDGE),
    CONSTANT(HS_CONTACT_EDGE_EDGE),
    CONSTANT(HS_CONTACT_EDGE_FACE),
    CONSTANT(HS_CONTACT_FACE_FACE),
    CONSTANT(HS_CONTACT_VERTEX_FACE),
    CONSTANT(HS_PAIR_FACE_VERTEX),
    CONSTANT(HS_PAIR_VERTEX_FACE),
    CONSTANT(HS_PAIR_EDGE_EDGE),
    CONSTANT(HS_PAIR_VERTEX_VERTEX),
    CONSTANT(HS_STIFFNESS_PER_CONTACT),
    CONSTANT(HS_STIFFNESS_PER_AREA),
    CONSTANT(HS_STIFFNESS_POTENTIAL),
    CONSTANT(HS_IMPACT_NEVER),
    CONSTANT(HS_IMPACT_AT_START),
    CONSTANT(HS_IMPACT_TOUCH),
    CONSTANT(HS_PLANE_STRAIN),
    CONSTANT(HS_PLANE_STRESS),
    CONSTANT(HS_BLOCK_FIXED),
    CONSTANT(HS_BLOCK_PRESCRIBED),
    CONSTANT(HS_BLOCK_RIGID),
    CONSTANT(HS_BLOCK_AFFINE),
    CONSTANT(HS_FAST_DIVIDE),
    CONSTANT(HS_FAST_REFUSE),
};

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
  size_t k;
  for (k = 0; k < sizeof constants / sizeof *constants; ++k)
    if (is(word, constants[k].name)) return constants[k].value;
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
