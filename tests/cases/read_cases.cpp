// The reader once more, as C++.
#include "read_cases.c"

#include "case_file.c"
#include "expectations.c"
#include "field_tables.c"
#include "fields.c"
#include "player.c"
