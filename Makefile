# Sanggwan.
#
#   make          the program (./sanggwan) and the library for plain swipl
#   make demo     draws the figures into docs/gallery
#   make test     every test; the last line counts them
#   make test-all all cases of those that do a sample otherwise
#   make docs     the reference and the list of files, in build/docs
#   make install  PREFIX=/usr/local DESTDIR=
#
# `make demo` and `make test` install what is missing from Debian's packages.
# While working: `make check-rules T=store`, `make check-c T=mesh`,
# `make check-cli T=bad`; `make lint`, `make check-san`, `make check-vg`,
# `make coverage`.
#
# Flat, no recursion. Everything made goes to build/.

.DELETE_ON_ERROR:
.SUFFIXES:
.DEFAULT_GOAL := all
SHELL   := /bin/bash
# Another B, anywhere, is a build of another kind: see check-san.
B       := build
$(if $(filter 1,$(words $(B))),,$(error B=$(B): make takes no spaces in names))
CC      ?= cc
PREFIX  ?= /usr/local
# It stands in rules/version.pl.
VERSION := $(shell sed -n "s/^version('\(.*\)')\.$$/\1/p" rules/version.pl)

# Goals that install what they need, beside what the build needs. deps.mk holds
# what pkg-config says; make re-reads this file after making it, so the flags
# are right even when SWI-Prolog was not there a moment ago. Its headers are those
# of a system: what a compiler warns of there is not ours. Packages are looked
# for before each of these goals, whether or not deps.mk is there already.
TESTING  := test test-all check check-san bench mutants
LINTING  := lint check-vg
INSTALLS := demo $(TESTING) $(LINTING)
PURPOSES := $(if $(filter $(TESTING),$(MAKECMDGOALS)),tests) \
            $(if $(filter $(LINTING),$(MAKECMDGOALS)),lint)
LOOK     := tools/deps $(PURPOSES) \
            $(if $(filter $(INSTALLS),$(MAKECMDGOALS)),--install)
ifneq ($(filter-out clean uninstall,$(or $(MAKECMDGOALS),all)),)
include $(B)/deps.mk
endif
$(B)/deps.mk: tools/deps Makefile \
              | $(if $(filter $(INSTALLS),$(MAKECMDGOALS)),packages)
	@mkdir -p $(B)
	@$(LOOK)
	@{ echo "PL_CFLAGS := $$(pkg-config --cflags-only-I swipl | \
	                         sed 's/-I */-isystem /g')" && \
	   echo "PL_LIBS := $$(pkg-config --libs swipl)" && \
	   echo "PL_ARCH := $$(swipl -g 'current_prolog_flag(arch, A), write(A)' \
	                         -t halt)" && \
	   echo "LEAKS := $$(echo 'int main(void) { return 0; }' | \
	       $(CC) -fsanitize=leak -x c - -o $(B)/leaks 2>/dev/null && \
	     $(B)/leaks 2>/dev/null && echo -fsanitize=leak)"; } > $@
packages:
	@$(LOOK)

OPT     ?= -O2
# -ffp-contract=off: no fused multiply-add may change a sign (exact.h).
# Glue: Prolog's own types mix signs, hence -Wno-sign-conversion there. Constants
# that are enums stand in sums of doubles: clang 19 warns of that by -Wextra.
WARN    := -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
           -Wmissing-prototypes -Wswitch-enum -Wno-enum-float-conversion \
           -Werror
# No SLP vectors: points that go through memory as pairs wait for their halves.
# Functions of a file may be inlined in it though others see them: nobody
# replaces them (-Bsymbolic).
# Headers are named from c_kernels/ (rows/sort.h), others of ours from here.
CFLAGS   = -std=c11 -D_GNU_SOURCE -I. -Ic_kernels -I$(B) $(OPT) -g -fPIC \
           -ffp-contract=off -fno-tree-slp-vectorize -fno-semantic-interposition
LIBS    := -lgmp -lz -lm -lpthread

C_SRC   := $(wildcard engine/*.c c_kernels/*.c c_kernels/*/*.c)
EMBED   := engine/start.c engine/engine.c engine/question.c
MAINS   := engine/main.c engine/signals.c engine/boot.c $(EMBED)
OBJS    := $(patsubst %.c,$(B)/%.o,$(filter-out $(MAINS),$(C_SRC))) \
           $(B)/doors.o
# Without Prolog: what the C tests link.
CORE    := $(filter-out %4pl.o %/install.o %/door_types.o %/door.o %/doors.o,$(OBJS))
RULES   := $(wildcard rules/*.pl rules/*/*.pl)
WEB     := $(wildcard web/*)

all: $(B)/sanggwan.so $(if $(wildcard rules/command/cli.pl),sanggwan)

.PHONY: all sanggwan packages so demo helpers test test-all check check-c \
        check-rules check-embed check-cli bless mutants check-san san san-text tsan coverage covered check-vg vg lint \
        docs clean install uninstall bench

# --- objects and libraries -------------------------------------------------

# exact.c: its own flags, whatever OPT says.
$(B)/c_kernels/number/exact.o: OPT := -O2
# Filters of rows of bytes, many at a time.
$(B)/c_kernels/drawing/image_png.o: OPT += -O3
# Rows and joins: small functions that are called in long loops.
FAST    := $(filter $(B)/engine/% \
             $(foreach f,join number pattern penetration picture polygon rows,\
               $(B)/c_kernels/$f/%),$(filter-out %4pl.o %/exact.o,$(OBJS)))
$(FAST): OPT := $(patsubst -O2,-O3,$(OPT))
$(B)/%4pl.o $(B)/c_kernels/door_types.o $(B)/c_kernels/door.o $(B)/doors.o \
  $(B)/engine/engine.o \
  $(B)/engine/question.o: \
	WARN += -Wno-sign-conversion
# The doors between Prolog and C are made (c_kernels/doors.def); headers that do
# not change are left alone.
$(B)/doors.made: tools/doors.pl $(wildcard tools/doors_*.pl rules/kernel/*.pl) \
                  c_kernels/doors.def
	@mkdir -p $(B)
	swipl -f none $< -- $(B)
	@touch $@
$(B)/doors.c: $(B)/doors.made ;
$(B)/doors.o: $(B)/doors.c $(B)/deps.mk
	$(CC) $(CFLAGS) $(WARN) $(PL_CFLAGS) $(EXTRA_CFLAGS) -MMD -MP -c $< -o $@
$(B)/%.o: %.c $(B)/deps.mk | $(B)/doors.made
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) $(PL_CFLAGS) $(EXTRA_CFLAGS) -MMD -MP -c $< -o $@
-include $(patsubst %.c,$(B)/%.d,$(C_SRC)) $(B)/doors.d

so: $(B)/sanggwan.so
$(B)/sanggwan.so: $(OBJS)
	$(CC) -shared -Wl,-Bsymbolic $(EXTRA_CFLAGS) $^ -o $@ $(LIBS)

# --- the program, its rules inside -----------------------------------------

# boot is Prolog with our C in it; it compiles the rules (tools/parts.pl: the
# core and the parts); carried.S puts them into the library.
$(B)/boot: $(B)/engine/boot.o $(OBJS)
	$(CC) $(EXTRA_CFLAGS) $^ -o $@ $(PL_LIBS) $(LIBS)
# The rules' documentation as plain facts, for help/1.
$(B)/documentation.pl: tools/documentation.pl $(RULES) $(B)/sanggwan.so
	swipl -f none -p foreign=$(B) $< -- $@
COMMA := ,
$(B)/core.qlf: $(B)/boot $(B)/documentation.pl tools/parts.pl $(WEB)
	$(B)/boot -q -f none -O --on-error=status \
	  -g "load_files('tools/parts.pl',[])" \
	  -g "sg_parts:parts('$@','$(B)/parts',[$(subst $(EMPTY) ,$(COMMA),$(WEB:%='%'))])" \
	  -t halt
# The rules alone, compiled: for a host in which Prolog already runs.
$(B)/embedded.qlf: $(B)/boot $(RULES)
	@echo ":- module(sg_embedded, []). :- use_module('$(CURDIR)/rules/sanggwan', [])." \
	  > $(B)/embedded.pl
	$(B)/boot -q -f none -O --on-error=status \
	  -g "qcompile('$(B)/embedded.pl',[include(user)])" -t halt
$(B)/carried.o: engine/carried.S $(B)/core.qlf $(B)/embedded.qlf
	$(CC) -DSG_CORE='"$(B)/core.qlf"' -DSG_PARTS='"$(B)/parts"' \
	  -DSG_RULES='"$(B)/embedded.qlf"' -c $< -o $@
$(B)/libsanggwan.a: $(OBJS) $(EMBED:%.c=$(B)/%.o) $(B)/carried.o
	@rm -f $@
	ar rcs $@ $^
# Prolog would start from a state of the program's name, as older builds left one.
$(B)/sanggwan: $(B)/engine/main.o $(B)/engine/signals.o $(B)/libsanggwan.a
	@rm -f $@.prc
	$(CC) $(EXTRA_CFLAGS) $^ -o $@ $(PL_LIBS) $(LIBS)
sanggwan: $(B)/sanggwan
	@[ "$$(readlink $@)" = $< ] || ln -sf $< $@

# --- tests -----------------------------------------------------------------

T       ?=
# T are parts of names, or folders.
NAMED   := $(or $(T),*)
C_TESTS := $(patsubst %.c,$(B)/%,$(sort $(wildcard $(foreach t,$(NAMED), \
             tests/c_kernels/*$(t)*_test.c tests/c_kernels/*/*$(t)*_test.c \
             tests/c_kernels/$(t:%/=%)/*_test.c tests/engine/*$(t)*_test.c))))
PLTS    := $(sort $(wildcard $(foreach t,$(NAMED), tests/rules/*$(t)*.plt \
             tests/rules/*/*$(t)*.plt tests/rules/$(t:%/=%)/*.plt)))
CLIS    := $(filter-out %/models.txt,$(sort $(wildcard $(foreach t,$(NAMED), \
             tests/cli/*$(t)*.sh tests/transcripts/*$(t)*.txt \
             tests/snapshots/*$(t)*.txt $(if $(T),tests/$(t:%/=%)/*.txt)))))

$(B)/libcore.a: $(CORE)
	@rm -f $@
	ar rcs $@ $^
# After a change of a kernel tests are linked, not compiled. One that does not give
# back what it took fails (LEAKS: LeakSanitizer, where it runs).
.PRECIOUS: $(B)/%.o
$(B)/tests/%_test: $(B)/tests/%_test.o $(B)/libcore.a
	$(CC) $(EXTRA_CFLAGS) $(if $(findstring sanitize,$(EXTRA_CFLAGS)),,$(LEAKS)) \
	  $(filter %.o,$^) $(B)/libcore.a -o $@ $(REFUSE) $(LIBS)
# Memory is that of refuse.h: it may be refused, and is no zero until it is set.
$(C_TESTS): $(B)/tests/memory/refuse.o
$(C_TESTS): REFUSE := $(patsubst %,-Wl$(COMMA)--wrap=%,malloc calloc realloc \
                        aligned_alloc free)
-include $(C_TESTS:%=%.d)

# The checker of results: shares nothing with the engine.
CHECKER := $(B)/tests/solid_checker
$(CHECKER): $(wildcard tests/checker/*.c) $(wildcard tests/checker/*.h)
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) $(EXTRA_CFLAGS) $(filter %.c,$^) -o $@ -lgmp -lm

# The checker of pictures: shares nothing with the engine either.
PICTURE_CHECKER := $(B)/tests/picture_checker
$(PICTURE_CHECKER): $(wildcard tests/picture_checker/*.[ch])
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) $(EXTRA_CFLAGS) $(filter %.c,$^) -o $@ -lgmp -lm

# The checker of patterns: the same.
PATTERN_CHECKER := $(B)/tests/pattern_checker
$(PATTERN_CHECKER): $(wildcard tests/pattern_checker/*.[ch]) \
                    tests/checker/boxes.c tests/checker/boxes.h
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) $(EXTRA_CFLAGS) $(filter %.c,$^) -o $@ -lm
CHECKERS = $(CHECKER) $(PICTURE_CHECKER) $(OUTLINE_CHECKER) $(SURFACE_CHECKER) \
           $(PATTERN_CHECKER)

# The checker of silhouettes.
OUTLINE_CHECKER := $(B)/tests/outline_checker
$(OUTLINE_CHECKER): tests/outline_checker/outline_checker.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) $(EXTRA_CFLAGS) $< -o $@ -lm

# The checker of drawings against true surfaces.
SURFACE_CHECKER := $(B)/tests/surface_checker
$(SURFACE_CHECKER): tests/surface_checker/surface_checker.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) $(EXTRA_CFLAGS) $< -o $@ -lm

# Programs that use the library as a host does: tests and the example.
EMBEDS  := $(patsubst %.c,$(B)/%,$(sort $(wildcard \
             $(foreach t,$(NAMED),tests/embed/*$(t)*_test.c))))
HOSTS   := $(patsubst %.c,$(B)/%,$(wildcard tests/embed/*_test.c))
$(HOSTS) $(B)/docs/example: $(B)/%: %.c engine/sanggwan.h tests/check.h \
                             $(B)/libsanggwan.a
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) -Wno-sign-conversion $(PL_CFLAGS) -Iengine \
	  $(EXTRA_CFLAGS) $< $(B)/libsanggwan.a -o $@ $(PL_LIBS) $(LIBS)

# An allocator that fails, before all others in a Prolog under test.
FAILING := $(B)/tests/failing_malloc.so
$(FAILING): tests/memory/failing_malloc.c $(B)/deps.mk
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) -Wno-sign-conversion -fno-builtin $(PL_CFLAGS) \
	  -shared $< -o $@

# How long a program works without asking whether it is to stop.
UNASKED := $(B)/tests/unasked.so
$(UNASKED): tests/polls/unasked.c $(B)/deps.mk
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARN) -Wno-pedantic -shared $< -o $@ -ldl -lrt

# The rules compiled: tests load them in a quarter of the time (load_rules.pl).
$(B)/rules.qlf: $(B)/sanggwan.so $(RULES)
	@echo ":- module(sg_rules, []). :- use_module('$(CURDIR)/rules/sanggwan.pl', [])." \
	  > $(B)/rules.pl
	swipl -q -f none -p foreign=$(B) --on-warning=status --on-error=status \
	  -g "qcompile('$(B)/rules.pl',[include(user)])" -t halt

# What tests load, or have loaded before the program.
helpers: $(CHECKERS) $(FAILING) $(UNASKED)

test: all $(B)/rules.qlf $(C_TESTS) $(EMBEDS) $(B)/docs/example helpers
	@$(or $(if $(strip $(C_TESTS) $(EMBEDS) $(PLTS) $(CLIS)),tests/run), \
	  echo 'no test is called so: $(T)' >&2; exit 2;) \
	  $(C_TESTS) $(EMBEDS) $(PLTS) $(CLIS)
# What tests do a sample of otherwise, in full.
test-all:
	@TEST_ALL=1 $(MAKE) --no-print-directory test
check: test
check-c: $(C_TESTS)
	@tests/run $^
check-rules: $(B)/rules.qlf $(B)/documentation.pl $(CHECKERS)
	@tests/run $(PLTS)
check-embed: $(EMBEDS)
	@tests/run $^
check-cli: all $(B)/rules.qlf $(B)/docs/example helpers
	@tests/run $(CLIS)

# Do the tests notice faults? N mutants of lines drawn by SEED; PART is a part
# of the paths of their files; FULL=1 tries every test.
N    ?= 20
SEED ?= 1
PART ?=
mutants: $(C_TESTS)
	@tools/mutants $(N) $(SEED) $(PART)

# --- checkers --------------------------------------------------------------

# Seconds that a test may take under a checker. A busy machine needs more.
CHECK_SECONDS := $(or $(TEST_SECONDS),1800)

# AddressSanitizer and UndefinedBehaviorSanitizer, in a build of their own. A
# Prolog that was not built with them wants their library loaded first and no
# threads (its collector of atoms would run in one); its own memory is not
# asked for leaks, the C tests are. What is read before it is written is no
# number and no address.
SAN := -fsanitize=address,undefined -fno-sanitize-recover=undefined \
       -fno-omit-frame-pointer -ftrivial-auto-var-init=pattern
# What needs them runs as it is built, for a minute: threads that come and go.
# With T only the tests of that name run.
STRESS    := $(filter %/stress_test,$(EMBEDS))
MESH_FUZZ := $(filter %/mesh_fuzz_test,$(C_TESTS))
TEXT_CLI  := $(filter %/text_fuzz.sh,$(CLIS))
check-san: $(STRESS)
	@$(if $(STRESS),STRESS_SECONDS=60 tests/run $(STRESS))
	@OPT=-O1 EXTRA_CFLAGS='$(SAN)' $(MAKE) --no-print-directory -s \
	  B=$(B)/san san
	@$(if $(TEXT_CLI),$(MAKE) --no-print-directory -s san-text)
	@OPT=-O1 EXTRA_CFLAGS='$(TSAN)' $(MAKE) --no-print-directory -s \
	  B=$(B)/tsan tsan
# Changed texts of every reader, read by the program with both sanitizers; the
# rules in it are those of the plain build.
MADE := documentation.pl core.qlf parts embedded.qlf
san-text: $(B)/sanggwan
	@mkdir -p $(B)/san
	@cp $(MADE:%=$(B)/%) $(B)/san
	@rm -f $(B)/san/carried.o
	@OPT=-O1 EXTRA_CFLAGS='$(SAN)' $(MAKE) --no-print-directory -s \
	  B=$(B)/san $(MADE:%=-o $(B)/san/%) $(B)/san/sanggwan
	@B=$(B)/san TEXT_FUZZ=$(or $(TEXT_FUZZ),400) TEST_SECONDS=$(CHECK_SECONDS) \
	  ASAN_OPTIONS=detect_leaks=0:use_sigaltstack=0:exitcode=99 \
	  tests/run tests/cli/text_fuzz.sh
san: $(B)/sanggwan.so $(C_TESTS) $(CHECKERS)
	@B=$(B) TEST_SECONDS=$(CHECK_SECONDS) tests/run $(C_TESTS)
	@$(if $(MESH_FUZZ),$(MESH_FUZZ) 20000)
	@echo 'skipped: the tests of rules that need threads'
	@B=$(B) TEST_SECONDS=$(CHECK_SECONDS) ASAN_OPTIONS=detect_leaks=0 SWIPL="env \
	  LD_PRELOAD=$$($(CC) -print-file-name=libasan.so) swipl --no-threads" \
	  tests/run $(PLTS)

# ThreadSanitizer, the same way: a Prolog without threads of its own leaves those
# of the store, and of the thread pool, which shares the work on meshes and
# pictures.
TSAN     := -fsanitize=thread -fno-omit-frame-pointer -Wno-maybe-uninitialized
TSAN_C   := thread_pool threads exact_point bvh leaf_tree hide_search solid_rows \
            complete self_cut
TSAN_PLT := solid/ model/mesh picture/hidden_lines penetration/penetration_m \
            penetration/resolve penetration/self_cut
tsan: export TSAN_OPTIONS = die_after_fork=0 exitcode=66
tsan: $(B)/sanggwan.so $(CHECKERS) \
      $(foreach t,$(TSAN_C),$(filter %/$(t)_test,$(C_TESTS)))
	@B=$(B) TEST_SECONDS=$(CHECK_SECONDS) tests/run $(filter %_test,$^)
	@B=$(B) TEST_SECONDS=$(CHECK_SECONDS) SWIPL="env \
	  LD_PRELOAD=$$($(CC) -print-file-name=libtsan.so) swipl --no-threads" \
	  tests/run $(sort $(foreach t,$(TSAN_PLT),$(filter tests/rules/$(t)%,$(PLTS))))

# How much of what decides exactly the C tests go through: lines and branches of
# each file, from gcov. The rules' tests go through the rest of it.
EXACT := $(addprefix c_kernels/,number/exact number/exact_point number/integers \
           number/number join/cut penetration/cut_point penetration/cut_overlap \
           penetration/cut_contact polygon/plane)
coverage:
	@OPT=-O1 EXTRA_CFLAGS='--coverage -Wno-maybe-uninitialized' \
	  $(MAKE) --no-print-directory -s B=$(B)/coverage covered
covered: $(C_TESTS)
	@find $(B) -name '*.gcda' -delete
	@B=$(B) TEST_SECONDS=$(CHECK_SECONDS) tests/run $(C_TESTS)
	@gcov -n -b $(EXACT:%=$(B)/%.gcda) | awk -F "['%:]" \
	  '/^File/ { own = $$2 ~ /[.]c$$/; file = $$2 } \
	   own && /^Lines/ { lines = $$2 } \
	   own && /^Taken/ { printf "%-34s lines %6.2f %%, branches %6.2f %%\n", \
	                            file, lines, $$2; n++; \
	              if ($$2 < 95) { less = less " " file } } \
	   END { if (less) { print "fewer than 95 % of the branches of:" less; \
	                     exit 1 } \
	         exit n != $(words $(EXACT)) }'

# Memcheck: the C tests that are not long, and the rules where Prolog holds
# memory of ours: worlds, work, glue. Threads as above.
VG     := valgrind -q --error-exitcode=9 --leak-check=full \
          --errors-for-leak-kinds=definite --suppressions=tests/swipl.supp
VG_PLT := chain decision mesh model store tree view work worlds
check-vg:
	@$(MAKE) --no-print-directory -s B=$(B)/vg LEAKS= vg
vg: $(B)/sanggwan.so $(C_TESTS)
	@RUN='$(VG)' TEST_SECONDS=$(CHECK_SECONDS) tests/run $(filter-out %/cut_test %/mesh_fuzz_test, \
	  $(C_TESTS))
	@echo 'skipped: the tests of rules that need threads'
	@SWIPL='$(VG) swipl --no-threads' TEST_SECONDS=$(CHECK_SECONDS) tests/run \
	  $(foreach t,$(VG_PLT),$(filter %/$(t).plt,$(PLTS)))

# Layout and flaws of the C, also what another compiler warns of;
# documentation, width and layers of all.
# tools/cppcheck.supp says what is not asked, and why.
FORMATTED := $(wildcard engine/*.[ch] c_kernels/*.[ch] c_kernels/*/*.[ch] \
               tests/*.h tests/*/*.[ch] tests/*/*/*.[ch] bench/*.c docs/*.c)
# clang and cppcheck read again only what changed since they found nothing.
CLANGED := $(patsubst %.c,$(B)/lint/%.ok,$(filter %.c,$(FORMATTED)))
$(CLANGED): $(B)/lint/%.ok: %.c $(B)/deps.mk | $(B)/doors.made
	@mkdir -p $(@D)
	@clang -fsyntax-only $(CFLAGS) $(WARN) -Wno-sign-conversion $(PL_CFLAGS) \
	  -Iengine -MMD -MP -MF $(@:.ok=.d) -MT $@ $<
	@touch $@
-include $(if $(filter lint,$(MAKECMDGOALS)),$(CLANGED:.ok=.d))
lint: $(B)/sanggwan.so $(CLANGED)
	@clang-format --dry-run -Werror $(FORMATTED)
	@mkdir -p $(B)/lint/cppcheck
	@cppcheck -q -j 2 --enable=warning,portability,performance --std=c11 \
	  --suppressions-list=tools/cppcheck.supp --error-exitcode=1 \
	  --cppcheck-build-dir=$(B)/lint/cppcheck -I. -Ic_kernels \
	  engine c_kernels tests
	@swipl -f none tools/check_layers.pl
	@swipl -f none tools/house.pl -- check docs/architecture.svg
	@swipl -f none -p foreign=$(B) --on-warning=status --on-error=status \
	  tools/lint.pl
	@echo 'lint: nothing found'

# --- drawings --------------------------------------------------------------

# The gallery: each picture by the command that stands under it.
demo: all
	@swipl -p foreign=$(B) tools/gallery.pl
# Writes the golden drawings, the transcripts and the snapshots anew. Look at what
# changed.
bless: all
	@swipl -p foreign=$(B) tools/bless.pl
	@tests/transcript.py --bless tests/transcripts/*.txt
	@tests/snapshot.py --bless tests/snapshots/*.txt

# What is written of the house from its own files.
docs: $(B)/documentation.pl
	@swipl -f none tools/house.pl -- drawing docs/architecture.svg
	@swipl -f none tools/house.pl -- files $(B)/docs/files.md
	@swipl -f none -p foreign=$(B) tools/reference.pl -- $(B)/docs/reference.md
	@echo 'docs: $(B)/docs/files.md, $(B)/docs/reference.md'

# What clangd and other tools ask of each C file.
compile_commands.json: $(B)/doors.made $(B)/deps.mk
	@{ echo '[' && \
	   printf '{"directory": "$(CURDIR)", "file": "%s", "arguments": [%s]},\n' \
	     $(foreach f,$(filter %.c,$(FORMATTED)),$f \
	       '$(foreach w,$(CC) $(CFLAGS) $(PL_CFLAGS) -Iengine -c $f,"$w",)') | \
	     sed 's/,]/]/; $$s/,$$//' && \
	   echo ']'; } >$@

# --- measuring -------------------------------------------------------------

# Every figure beside its peer of the same run; docs/performance.md explains.
bench: all
	@bench/run -d

# --- installing ------------------------------------------------------------

# DESTDIR stands before every path, as packagers want; tools/install says what
# goes where.
install: all $(B)/sanggwan.1
	@B=$(B) DESTDIR='$(DESTDIR)' tools/install '$(PREFIX)' $(VERSION) $(PL_ARCH)
uninstall:
	@DESTDIR='$(DESTDIR)' tools/install --remove '$(PREFIX)'
$(B)/sanggwan.1: tools/manual.pl rules/command/usage.pl
	swipl -f none tools/manual.pl -- $(VERSION) $@

clean:
	rm -rf $(B) sanggwan compile_commands.json
