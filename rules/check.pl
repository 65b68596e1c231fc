:- module(sg_check,
          [ check_report/1,             % -Report
            print_report/2,             % +Format, +Report
            report_faults/2             % +Report, -Count
          ]).
:- encoding(utf8).
:- use_module(integrity, [model_defect/1, edge_uses/3, segment_volume/2]).
:- use_module(store, [v/5, p/3, t/6, segment/3]).
:- autoload(library(aggregate), [aggregate_all/3]).
:- autoload(library(apply), [foldl/4, maplist/3]).
:- autoload(library(http/json), [json_write_dict/3]).
:- autoload(library(lists), [member/2, nth1/3]).
:- set_prolog_flag(optimise, true).
/** <module> The report of the verb check: measures and defects.
*/

%!  check_report(-Report) is det.
%
%   Report is a dict of the current world:
%
%     - segments: a list of dicts with segment, kind, name, vertices, edges,
%       polygons, triangles, box ([XMin,YMin,ZMin,XMax,YMax,ZMax] or null),
%       area, and of surfaces and solids border_edges, euler (V-E+F of the
%       triangles), of closed solids volume and genus (of one shell)
%     - defects: a dict with the number of each kind of model_defect/1
%     - first: the first defects of each kind, as text, three at most
%     - faults: the number of all defects

check_report(_{segments:Segments, defects:Counts, first:Firsts,
               faults:Faults}) :-
    findall(S, segment(S, _, _), Ss0),
    sort(Ss0, Ss),
    maplist(segment_report, Ss, Segments),
    findall(Kind-Defect, ( model_defect(Defect), functor(Defect, Kind, _) ),
            Pairs),
    length(Pairs, Faults),
    findall(Kind-N, ( defect_kind(Kind),
                      aggregate_all(count, member(Kind-_, Pairs), N) ),
            CountPairs),
    dict_pairs(Counts, _, CountPairs),
    findall(Text, ( defect_kind(Kind), between(1, 3, I),
                    nth_defect(I, Kind, Pairs, Defect),
                    format(string(Text), '~q', [Defect]) ),
            Firsts).

defect_kind(open_edge).
defect_kind(unpaired_edge).
defect_kind(non_manifold_edge).
defect_kind(degenerate_face).
defect_kind(inside_out).

nth_defect(I, Kind, Pairs, Defect) :-
    findall(D, member(Kind-D, Pairs), Defects),
    nth1(I, Defects, Defect).

%!  report_faults(+Report, -Count) is det.
%
%   Count is the number of defects in Report.

report_faults(Report, Report.faults).

segment_report(S, Report) :-
    segment(S, Kind, Name0),
    format(string(Name), '~w', [Name0]),
    aggregate_all(count, v(S, _, _, _, _), Vertices),
    aggregate_all(count, p(S, _, _), Polygons),
    aggregate_all(count, t(S, _, _, _, _, _), Triangles),
    findall(Uses, edge_uses(S, _, Uses), AllUses),
    length(AllUses, Edges),
    aggregate_all(count, border(AllUses), Border),
    segment_box(S, Box),
    segment_area(S, Area),
    Report0 = _{segment:S, kind:Kind, name:Name, vertices:Vertices,
                edges:Edges, polygons:Polygons, triangles:Triangles, box:Box,
                area:Area, border_edges:Border},
    (   Kind == solid,
        Border =:= 0,
        Triangles > 0
    ->  segment_volume(S, Volume),
        euler(S, Triangles, Euler),
        Report1 = Report0.put(_{volume:Volume, euler:Euler}),
        (   Euler mod 2 =:= 0
        ->  Genus is (2-Euler)//2,
            Report = Report1.put(genus, Genus)
        ;   Report = Report1
        )
    ;   Report = Report0
    ).

border(AllUses) :-
    member(uses(F, B), AllUses),
    F =\= B.

%   euler(S, Triangles, Euler): V-E+F of closed triangles: every one has three
%   half-edges, so E = 3F/2, and V counts the vertices that are used.

euler(S, F, Euler) :-
    findall(V, corner(S, V), Vs0),
    sort(Vs0, Vs),
    length(Vs, V),
    Euler is V - 3*F//2 + F.

corner(S, V) :-
    t(S, _, _, A, B, C),
    member(V, [A, B, C]).

segment_box(S, Box) :-
    (   aggregate_all(r(min(X), min(Y), min(Z), max(X), max(Y), max(Z)),
                      v(S, _, X, Y, Z), r(A, B, C, D, E, F))
    ->  Box = [A, B, C, D, E, F]
    ;   Box = null
    ).

segment_area(S, Area) :-
    aggregate_all(sum(A), triangle_area(S, A), Area0),
    Area is float(Area0).

triangle_area(S, Area) :-
    t(S, _, _, A, B, C),
    v(S, A, X0, Y0, Z0),
    v(S, B, XB, YB, ZB),
    v(S, C, XC, YC, ZC),
    X1 is XB-X0, Y1 is YB-Y0, Z1 is ZB-Z0,
    X2 is XC-X0, Y2 is YC-Y0, Z2 is ZC-Z0,
    Nx is Y1*Z2-Z1*Y2, Ny is Z1*X2-X1*Z2, Nz is X1*Y2-Y1*X2,
    Area is sqrt(Nx*Nx+Ny*Ny+Nz*Nz)/2.0.


                /*******************************
                *            PRINTING          *
                *******************************/

%!  print_report(+Format, +Report) is det.
%
%   Print Report on the current output; Format is `text` or `json`.

print_report(json, Report) :-
    json_write_dict(current_output, Report, [width(72)]),
    nl.
print_report(text, Report) :-
    forall(member(Segment, Report.segments), print_segment(Segment)),
    dict_pairs(Report.defects, _, Pairs),
    (   Report.faults =:= 0
    ->  format("no defects~n")
    ;   forall(( member(Kind-N, Pairs), N > 0 ),
               format("~D ~w~n", [N, Kind])),
        forall(member(Text, Report.first), format("  ~s~n", [Text]))
    ).

print_segment(R) :-
    format("segment ~d: ~w ~w~n", [R.segment, R.kind, R.name]),
    format("  ~D vertices, ~D edges, ~D polygons, ~D triangles~n",
           [R.vertices, R.edges, R.polygons, R.triangles]),
    (   R.box = [A, B, C, D, E, F]
    ->  format("  box ~w ~w ~w to ~w ~w ~w~n", [A, B, C, D, E, F])
    ;   true
    ),
    (   R.triangles > 0
    ->  format("  area ~w~n", [R.area])
    ;   true
    ),
    (   get_dict(volume, R, Volume)
    ->  format("  volume ~w, closed~n", [Volume])
    ;   R.polygons > 0
    ->  format("  ~D border edges~n", [R.border_edges])
    ;   true
    ),
    (   get_dict(genus, R, Genus)
    ->  format("  Euler number ~d, genus ~d (if one shell)~n",
               [R.euler, Genus])
    ;   get_dict(euler, R, Euler)
    ->  format("  Euler number ~d: shells touch in a vertex~n", [Euler])
    ;   true
    ).
