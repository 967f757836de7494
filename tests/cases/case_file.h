/* The lines of a case file as words. C99 that is C++ as well. */
#ifndef HALFSPACE_CASE_FILE_H
#define HALFSPACE_CASE_FILE_H

#include <stdint.h>
#include <stdio.h>

enum { MOST_CHARACTERS = 1000, MOST_WORDS = 100 };

typedef struct Statement {
  int line;
  int count;               /* of words */
  char* words[MOST_WORDS]; /* into text */
  char text[MOST_CHARACTERS + 2];
  char rest[MOST_CHARACTERS + 2]; /* the text after the second word, as it stands */
} Statement;

/* Reads the next line that says something; 0 at the end of the file. Ends the program when a line is too
 * long. */
int next_statement(FILE* file, Statement* statement);

/* Word i as a number; ends the program, naming the line, when it is none or not there. A constant's name is
 * one. */
double number_at(const Statement* statement, int i);

/* Words from `first` on as numbers, as many as there are up to `most`; returns their number. */
int numbers_from(const Statement* statement, int first, double* numbers, int most);

/* Word i; ends the program when it is not there. */
const char* word_at(const Statement* statement, int i);

/* Are two words the same? */
int is(const char* word, const char* other);

/* Ends the program: the file breaks its own rules. */
void malformed(const Statement* statement, const char* what);

#endif
