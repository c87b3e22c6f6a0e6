#!/usr/bin/perl
# Makes of what GitHub and programmers read what Doxygen 1.9 links. In all files, `Class_2` in backticks becomes a
# reference to the class. In pages, headings get labels, and links to pages, headings, examples and concepts become
# references; links to other files become plain text, if these exist; and <!-- example x.cpp --> becomes its text. Code
# with an apostrophe, which would end it, gets two backticks.
use strict;
use warnings;

my ($file) = $ARGV[0] =~ m{([^/]+)$};
my ($page) = $file =~ m{^(\w+)\.md$};

# As GitHub makes it.
sub slug {
  my $text = lc shift;
  $text =~ s/[^\w\- ]//g;
  $text =~ tr/ /-/;
  return $text;
}

sub label {
  my ($page, $heading) = @_;
  $heading =~ tr/-/_/;
  return $heading eq '' ? "page_$page" : "page_${page}_$heading";
}

# The text of a reference is plain text to Doxygen.
sub link_to {
  my ($text, $target) = @_;
  my $plain = $text =~ tr/`//dr;
  return "[$plain](\@ref " . label($page, $1) . ')' if $target =~ /^#(.*)$/;
  return "[$plain](\@ref " . label($1, $2 // '') . ')' if $target =~ m{^(\w+)\.md(?:#(.*))?$} && -e "doc/$1.md";
  return "[$plain](\@ref $1)" if $target =~ m{^Concepts/(\w+)\.h$} || $target =~ m{^\.\./examples/(\w+\.cpp)$};
  return "[$text]($target)" if $target =~ m{^https?://};
  return $text if -e "doc/$target";
  return "[$plain](\@ref $target)"; # which is not there: an error
}

# A class has a header of its own.
sub class_name {
  my ($code, $name) = @_;
  return -e "include/CGAL/$name.h" ? "\\ref CGAL::$name \"$name\"" : $code;
}

my $in_code = 0;
while (<>) {
  $in_code = !$in_code if defined $page && /^```/;
  if (defined $page ? !$in_code && !/^    / : m{^\s*///|///<}) {
    s/(`(?:CGAL::)?([A-Z]\w*)(?:<[\w, ]*>)?`)/class_name($1, $2)/ge unless /\[`/;
  }
  if (defined $page && !$in_code && !/^    /) {
    s/!\[([^\]]*)\]\((?:[\w.]+\/)*(\w+\.svg)\)/\@image html $2 "$1"/;
    s/^<!-- example (\w+\.cpp) -->$/\\include $1/;
    s/(?<!!)\[([^\]]*)\]\(([^)\s]+)\)/link_to($1, $2)/ge;
    s/(?<!`)`([^`]+)`(?!`)/index($1, "'") < 0 ? "`$1`" : "``$1``"/ge if tr/`// % 2 == 0;
    s/^(#+) (.*?)\s*$/"$1 $2 {#" . label($page, length($1) == 1 ? '' : slug($2)) . "}\n"/e;
  }
  print;
}
