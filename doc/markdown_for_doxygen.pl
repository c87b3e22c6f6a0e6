#!/usr/bin/perl
# Makes of a page for GitHub one for Doxygen 1.9: headings get labels, and links to pages, headings, examples and
# headers become references. Links to what is not in the manual become plain text.
use strict;
use warnings;

my ($page) = $ARGV[0] =~ m{([^/]+)\.md$} or die "not a Markdown file: $ARGV[0]\n";

# As GitHub makes it.
sub slug {
  my $text = lc shift;
  $text =~ s/[^\w\- ]//g;
  $text =~ tr/ /-/;
  return $text;
}

sub label {
  my ($file, $heading) = @_;
  $heading =~ tr/-/_/;
  return $heading eq '' ? "page_$file" : "page_${file}_$heading";
}

sub link_to {
  my ($text, $target) = @_;
  return "[$text](\@ref " . label($page, $1) . ')' if $target =~ /^#(.*)$/;
  return "[$text](\@ref " . label($1, $2 // '') . ')' if $target =~ m{^(\w+)\.md(?:#(.*))?$} && -e "doc/$1.md";
  return "[$text](\@ref $1)" if $target =~ m{^Concepts/(\w+)\.h$} || $target =~ m{^\.\./examples/(\w+\.cpp)$};
  return "[$text]($target)" if $target =~ m{^https?://};
  return $text;
}

my $in_code = 0;
while (<>) {
  $in_code = !$in_code if /^```/;
  if (!$in_code && !/^    /) {
    s/!\[([^\]]*)\]\((?:[\w.]+\/)*(\w+\.svg)\)/\@image html $2 "$1"/;
    s/(?<!!)\[([^\]]*)\]\(([^)\s]+)\)/link_to($1, $2)/ge;
    s/^(#+) (.*?)\s*$/"$1 $2 {#" . label($page, length($1) == 1 ? '' : slug($2)) . "}\n"/e;
  }
  print;
}
