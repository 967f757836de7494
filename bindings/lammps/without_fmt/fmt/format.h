// This program is free software: you can redistribute it and modify it under the terms of the GNU General
// Public License, version 2, as published by the Free Software Foundation. It is linked with LAMMPS, which
// has that licence.
#pragma once

// Debian packages the headers of LAMMPS without those of its fmt. They name these, in functions that are not
// called here.

namespace fmt {

struct string_view;
struct format_args;
template <class... Args, class Format>
format_args make_args_checked(const Format& format, Args&... args);

}  // namespace fmt
