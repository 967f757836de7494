/* read_cases FILE.case ...: makes the calls of the files and compares with the values in them (README.md). */
#include <stdlib.h>
#include <string.h>

#include "player.h"

/* The call went as it had to: refused with this status and text if the next statement says so, else done. */
static int as_expected(const Player* player, const Statement* call, hs_status status, const Statement* next) {
  const char* text = hs_context_last_error(player->context);
  if (!next) {
    if (status >= 0) return 1;
    printf("  line %d: status %d: %s\n", call->line, status, text);
    return 0;
  }
  if (status == (hs_status)number_at(next, 1) && strstr(text, next->rest)) return 1;
  printf("  line %d: status %d, text: %s\n", next->line, status, text);
  return 0;
}

typedef struct Tally {
  int cases, checks, failures;
} Tally;

static void read_file(const char* path, Player* player, Tally* tally) {
  FILE* file = fopen(path, "r");
  Statement statement, call_before;
  hs_status status = HS_OK;
  int pending = 0, more;
  if (!file) {
    fprintf(stderr, "cannot open %s\n", path);
    exit(2);
  }
  printf("%s\n", path);
  statement.line = 0;
  do {
    more = next_statement(file, &statement);
    const int is_refusal = more && is(statement.words[0], "refused");
    if (pending)
      tally->failures += !as_expected(player, &call_before, status, is_refusal ? &statement : NULL);
    pending = 0;
    if (is_refusal) ++tally->checks;
    if (!more || is_refusal) continue;
    if (is(statement.words[0], "case")) {
      ++tally->cases;
      begin_case(player);
    } else if (is(statement.words[0], "expect")) {
      ++tally->checks;
      tally->failures += !meets_expectation(player, &statement);
    } else {
      status = call(player, &statement);
      call_before = statement;
      pending = 1;
    }
  } while (more);
  begin_case(player);
  fclose(file);
}

int main(int argc, char** argv) {
  Player player;
  Tally tally = {0, 0, 0};
  int i;
  memset(&player, 0, sizeof player);
  if (hs_context_create(NULL, &player.context) != HS_OK) return 2;
  begin_case(&player);
  for (i = 1; i < argc; ++i) read_file(argv[i], &player, &tally);
  hs_context_destroy(player.context);
  printf("%d cases, %d checks, %d failures\n", tally.cases, tally.checks, tally.failures);
  return tally.failures > 0 || tally.checks == 0;
}
