/* vertex_list_test.c -- lists of vertices, their edges, and what is wrong with
 * a border; and the doors that ask it of the world.
 *
 * covers: vertex_list, vertex_list_rows
 */
#include "doors/file.h"
#include "model/vertex_list.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"

enum { MOST = 16 };

static sg_border_fault
fault_of(const int32_t *v, size_t n, int32_t what[2])
{
  sg_list_edge edge[MOST];
  int32_t scratch[MOST];
  size_t edges;

  CHECK("a list", sg_vertex_list_edges(v, n, edge, &edges) && edges <= n);
  return sg_border_find_fault(edge, edges, scratch, what);
}

#define FAULT_OF(what, ...)                                                    \
  fault_of((const int32_t[]){__VA_ARGS__},                                     \
           sizeof((const int32_t[]){__VA_ARGS__}) / sizeof(int32_t), what)
#define IS_LIST(...)                                                           \
  sg_vertex_list_edges(                                                        \
      (const int32_t[]){__VA_ARGS__},                                          \
      sizeof((const int32_t[]){__VA_ARGS__}) / sizeof(int32_t), edge, &n)

static void
test_lists(void)
{
  sg_list_edge edge[MOST];
  size_t n;
  int32_t what[2];

  CHECK("closed",
        IS_LIST(1, 2, 3) && n == 3 && edge[2].from == 3 && edge[2].to == 1);
  CHECK("closed already", IS_LIST(1, 2, 3, 1) && n == 3);
  CHECK("a jump", IS_LIST(1, 2, 3, 1, -5, 6, 7, 5) && n == 6 &&
                      edge[3].from == 5 && edge[3].to == 6);
  CHECK("no list", !sg_vertex_list_edges(NULL, 0, edge, &n));
  CHECK("a jump first", !IS_LIST(-1, 2, 3));
  CHECK("a jump last", !IS_LIST(1, 2, 3, -4));
  CHECK("two jumps", !IS_LIST(1, 2, -3, -4, 5));
  CHECK("no number", !IS_LIST(1, 0, 3));
  CHECK("good", FAULT_OF(what, 1, 2, 3) == SG_BORDER_GOOD);
  CHECK("few", FAULT_OF(what, 1, 2) == SG_BORDER_EDGES);
  CHECK("no edge",
        FAULT_OF(what, 1, 2, 2, 3, 3) == SG_BORDER_NO_EDGE && what[0] == 2);
  CHECK("twice", FAULT_OF(what, 1, 2, 3, 1, 2, 4) == SG_BORDER_TWICE &&
                     what[0] == 1 && what[1] == 2);
  CHECK("open",
        FAULT_OF(what, 1, 2, 3, -4, 5) == SG_BORDER_OPEN && what[0] == 1);
}

static void
test_doors(void)
{
  int32_t good[] = {1, 2, 3}, missing[] = {1, 2, 9}, loop[] = {1, 2, 2};
  int32_t jump[] = {-1, 2};
  sg_vertex_list_fault fault;
  sg_chain_fault chain;

  CHECK("good", !sg_door_vertex_list_fault(
                    &call, 1, &(sg_int_list){.at = good, .n = 3}, &fault));
  CHECK("missing",
        sg_door_vertex_list_fault(
            &call, 1, &(sg_int_list){.at = missing, .n = 3}, &fault) &&
            fault.is == SG_VERTEX_LIST_FAULT_MISSING && fault.missing.v == 9);
  CHECK("a loop",
        sg_door_vertex_list_fault(&call, 1, &(sg_int_list){.at = loop, .n = 3},
                                  &fault) &&
            fault.is == SG_VERTEX_LIST_FAULT_NO_EDGE && fault.no_edge.v == 2);
  CHECK("no list", sg_door_vertex_list_fault(
                       &call, 1, &(sg_int_list){.at = jump, .n = 2}, &fault) &&
                       fault.is == SG_VERTEX_LIST_FAULT_LIST);
  CHECK("another segment",
        sg_door_vertex_list_fault(&call, 2, &(sg_int_list){.at = good, .n = 3},
                                  &fault) &&
            fault.is == SG_VERTEX_LIST_FAULT_MISSING);
  CHECK("a chain", !sg_door_chain_fault(
                       &call, 1, &(sg_int_list){.at = good, .n = 3}, &chain));
  CHECK("missing",
        sg_door_chain_fault(&call, 1, &(sg_int_list){.at = missing, .n = 3},
                            &chain) &&
            chain.is == SG_CHAIN_FAULT_MISSING && chain.missing.v == 9);
  CHECK("a loop", sg_door_chain_fault(
                      &call, 1, &(sg_int_list){.at = loop, .n = 3}, &chain) &&
                      chain.is == SG_CHAIN_FAULT_CHAIN && chain.chain.v == 2);
}

int
main(void)
{
  sg_world *world = sg_world_open();

  for (int32_t v = 1; v <= 3; v++) {
    sg_fault fault;

    CHECK("a vertex",
          sg_world_add(world, SG_V,
                       (sg_value[SG_MAX_COLUMNS]){
                           {.i = 1}, {.i = v}, {.f = v}, {.f = 0}, {.f = 0}},
                       NULL, &fault) == SG_OK);
  }
  test_lists();
  sg_call_open(&call, NULL, NULL);
  call.world = world;
  test_doors();
  sg_call_close(&call);
  sg_world_drop(world);
  return check_report();
}
