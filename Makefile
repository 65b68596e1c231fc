# Sanggwan. `make demo` draws the figures, `make test` runs every test; both
# install what is missing from Debian's packages.
#
# Flat, no recursion. Everything made goes to build/.

.DELETE_ON_ERROR:
SHELL   := /bin/bash
B       := build
CC      ?= cc
PL      := $(shell pkg-config --cflags --libs swipl 2>/dev/null)
PLINC   := $(shell pkg-config --cflags swipl 2>/dev/null)
OPT     ?= -O2
# -ffp-contract=off: no fused multiply-add may change a sign (STYLE).
CFLAGS  := -std=c11 -D_GNU_SOURCE $(OPT) -g -fPIC -ffp-contract=off \
           -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
           -Wmissing-prototypes -Wswitch-enum -Werror $(EXTRA_CFLAGS)
LIBS    := -lgmp -lz -lm -lpthread

C_SRC   := $(wildcard engine/*.c c_kernels/*.c)
MAINS   := engine/main.c engine/boot.c engine/start.c
LIB_SRC := $(filter-out $(MAINS),$(C_SRC))
OBJS    := $(LIB_SRC:%.c=$(B)/%.o)
# Without Prolog: what the C tests link.
CORE    := $(filter-out %4pl.o %/install.o %/engine.o %/glue.o,$(OBJS))
RULES   := $(wildcard rules/*.pl)

all: $(B)/sanggwan.so

$(B)/%4pl.o: EXTRA_CFLAGS += -Wno-sign-conversion
$(B)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(PLINC) -MMD -MP -c $< -o $@
-include $(OBJS:.o=.d)

$(B)/sanggwan.so: $(OBJS)
	$(CC) -shared $(EXTRA_CFLAGS) $^ -o $@ $(LIBS)
