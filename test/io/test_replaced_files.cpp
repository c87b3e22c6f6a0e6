// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "scratch_folder.h"

#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

namespace test_replaced_files {

using CGAL::Quadtree_mesh_2::internal::Replaced_files;
namespace fs = std::filesystem;

TEST_CASE("files appear together, with the permissions of those they replace", "[replaced_files]") {
  const Scratch_folder folder;
  const std::string a = folder.write("a", "old"), b = folder.file("b");
  fs::permissions(a, fs::perms::owner_read | fs::perms::owner_write);
  Replaced_files files;
  files.add(a, "new");
  files.add(b, "other");
  CHECK(content(a) == "old");
  CHECK(!fs::exists(b));
  files.commit();
  CHECK(content(a) == "new");
  CHECK(content(b) == "other");
  CHECK(fs::status(a).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("files that are not put in place leave nothing", "[replaced_files]") {
  const Scratch_folder folder;
  const std::string a = folder.write("a", "old");
  {
    Replaced_files files;
    files.add(a, "new");
    files.add(folder.file("b"), "other");
    CHECK_THROWS_AS(files.add(folder.file("none/c"), "more"), std::system_error);
  }
  CHECK(content(a) == "old");
  CHECK(folder.number_of_files() == 1);
}

TEST_CASE("where one file cannot be put in place the others are as they were", "[replaced_files]") {
  const Scratch_folder folder;
  const std::string a = folder.write("a", "old");
  {
    Replaced_files files;
    files.add(a, "new");
    files.add(folder.file("b"), "other");
    files.add(folder.file("c"), "third");
    files.add(folder.file("d"), "fourth");
    fs::create_directory(folder.file("c")); // in the way since the file was written
    CHECK_THROWS_AS(files.commit(), std::system_error);
  }
  CHECK(content(a) == "old");
  CHECK(fs::is_directory(folder.file("c")));
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("a device that takes nothing stops all files", "[replaced_files]") {
  if (!fs::exists("/dev/full")) return;
  const Scratch_folder folder;
  {
    Replaced_files files;
    files.add(folder.file("a"), "new");
    fs::create_symlink("/dev/full", folder.file("full"));
    files.add(folder.file("full"), "other");
    CHECK_THROWS_AS(files.commit(), std::system_error);
  }
  CHECK(folder.number_of_files() == 1);
}

TEST_CASE("an open file gets its text when all is written, and stays open", "[replaced_files]") {
  const Scratch_folder folder;
  std::FILE* const open = std::fopen(folder.file("open").c_str(), "wb");
  REQUIRE(open != nullptr);
  std::fputs("head ", open);
  {
    Replaced_files files;
    files.direct("-.off", open, "standard output");
    files.add("-.off", "text ");
    files.add(folder.file("b"), "other");
    std::fflush(open);
    CHECK(content(folder.file("open")) == "head ");
    files.commit();
  }
  CHECK(content(folder.file("open")) == "head text ");
  std::fputs("tail", open);
  std::fclose(open);
  CHECK(content(folder.file("open")) == "head text tail");
  CHECK(content(folder.file("b")) == "other");
  CHECK(folder.number_of_files() == 2);
}

} // namespace test_replaced_files
