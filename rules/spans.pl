:- module(sanggwan_spans, []).
/** <module> Pictures as relations: slices, spans and what is seen in them.

A shaded picture is made scan line by scan line. These predicates ask what a
line meets and what is seen on it. sanggwan.pl has what a first model needs.
*/
:- use_module(topics, [topic/2]).

:- topic(spans, "Slices and spans of shaded pictures").
:- reexport(shading/shading_scene, [ shading_scene/2, scene_leaf/2 ]).
:- reexport(shading/seen,
            [ slice/3, met/4, seen_layers/4, line_spans/3, seen_side/5 ]).
:- reexport(shading/surface_look, [line_layers/3]).
:- reexport(shading/pick, [pick/3]).
:- reexport(shading/shading_scan, [scan/1]).
