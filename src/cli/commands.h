#pragma once

#include "arguments.h"

namespace heed::cli {

int run_command(const Arguments& arguments);
int kb_command(const Arguments& arguments);
int explain_command(const Arguments& arguments);
int spec_command(const Arguments& arguments);
int convert_command(const Arguments& arguments);
int synth_command(const Arguments& arguments);
int verify_command(const Arguments& arguments);
int simulate_command(const Arguments& arguments);
int tune_command(const Arguments& arguments);
int profile_command(const Arguments& arguments);
int play_command(const Arguments& arguments);
int drive_command(const Arguments& arguments);
int export_command(const Arguments& arguments);
int exec_command(const Arguments& arguments);
int version_command(const Arguments& arguments);

}  // namespace heed::cli
