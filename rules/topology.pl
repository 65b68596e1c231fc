:- module(sanggwan_topology, []).
/** <module> What is beside what: half-edges, cycles, disks, Euler operators.

These predicates walk over the facets of any model, and over the cells of one
that is glued. sanggwan.pl has what a first model needs.
*/
:- use_module(topics, [topic/2]).
:- use_module(spans, []).

:- set_module(base(sanggwan_spans)).

:- topic(half_edges, "Half-edges and facets").
:- reexport(vocabulary,
            [ half_edge/1, half_edge_ends/3, half_edge_twin/2,
              half_edge_facet/2, facet/1, facet_loops/2, facet_plane/2,
              facet_triangle/2, facet_neighbour/2, vertex_point/2,
              vertex_half_edge/2, edge_facets/2, shell_facets/2 ]).

:- topic(cells, "Regions, cycles and disks of a glued model").
:- reexport(gluing/regions, [region_neighbour/4]).
:- reexport(gluing/cycle, [ loop_cycle/4, radial_cycle/4, disk/4 ]).
:- reexport(gluing/region_border, [zone/4, shell/4]).
:- reexport(gluing/region_name, [region_name/3, region_named/3]).
:- reexport(gluing/vertex_disk,
            [ disk_arcs/2, disk_direction/2, zone_at/3, disk_relation/3 ]).

:- topic(local_gluing, "Gluing and taking apart at one place").
:- reexport(gluing/euler, [euler/3]).
:- reexport(solid/part_glue,
            [ glue_vertices/4, glue_edges/4, glue_faces/4, glue_mixed/4 ]).
:- reexport(gluing/unglue, [unglued_polygons/3, unglued_region/4]).
