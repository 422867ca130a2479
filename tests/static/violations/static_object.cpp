// SPDX-License-Identifier: MIT
// A library with an object that is to be destroyed at the end of the program.
namespace fixrad {

int open_files();
void close_file(int);

struct File {
  int handle = open_files();
  ~File() { close_file(handle); }
};

int handle() {
  static File file;
  return file.handle;
}

}  // namespace fixrad
