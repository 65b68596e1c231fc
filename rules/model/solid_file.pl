:- module(sg_solid_file,
          [ write_solid/2,              % +File, +S
            write_solid/3,              % +File, +S, +Options
            write_solids/3,             % +File, +Pairs, +Options
            output_statistics/1         % -Statistics
          ]).
:- use_module('../solid/boolean', [boolean/3]).
:- use_module('../kernel',
              [ boundary_open/7, boundary_coarsen/3, boundary_close/1,
                boundary_counts/2, boundary_meetings/3, boundary_add/2,
                boundary_write/5, fill_triangles/3
              ]).
:- use_module(mesh,
              [ mesh_file_format/3, mesh_to_file/2, mesh_names/4,
                mesh_outcome/1
              ]).
:- use_module(model_writer, [write_model/1]).
:- use_module('../limits', [limit_value/2]).
:- use_module('../output', [asked_for/2]).
:- use_module('../penetration/penetration', [penetrate/2]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ v/5, p/3, segment/3, origin/3, assert_fact/1, facts_snapshot/1,
                fresh_id/3
              ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/5, foldl/6, partition/4]).
:- use_module(library(error), [existence_error/2, must_be/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [pairs_keys_values/3]).
/** <module> Solids to files: what is read back is closed and clean.

The numbers of a file are not those of the model: STL has float32. Rounding can
put vertices together, make triangles collapse and fold thin parts over. So a
solid goes to a mesh file in these steps.

 1. Coordinates are rounded as the format stores them. Vertices in one place
    become one, and what has collapsed goes, so that nothing opens
    (c_kernels/model/boundary.h).
 2. The rounded numbers are checked: every edge has its opposite, and no
    triangle goes through another one. What rounding, a cut or the division of a
    polygon has made is checked against everything; the rest is as the solid has
    it.
 3. If something is wrong, the rounded mesh is united with itself, rounded, and
    checked again, all of it. What goes through itself even then goes to a
    coarser grid: the triangles concerned and what is near their corners, no
    others (output_grid/4 below says how coarse). Five times at most.
 4. The file is written beside, and takes its name.

The bytes depend on where the solid is alone: vertices ascend by their
coordinates, each face begins with its lowest vertex, and faces ascend. Where
bodies touch in a point or an edge the formats with numbered vertices get copies
(c_kernels/model/boundary_mesh.h); in the relations, and in model files, they
share.
*/

%!  write_solid(+File, +S) is det.
%!  write_solid(+File, +S, +Options) is det.
%
%   Write solid S of the current world to File (`-`: standard output): `.stl`,
%   `.off`, `.obj`, `.ply` or, with all of the world as it is, `.pl`. Options:
%
%     - format(Format), binary(Bool)
%       As of write_mesh/3; STL is binary unless binary(false). Text STL has
%       float32 numbers too, all their digits.
%     - name(Name)
%       What the solid is called in the file; by default as in segment/3.
%     - shared(true)
%       No copies: vertices and edges in which bodies touch stay shared.
%     - check(Which)
%       `changed`, as step 2 says; `all`: every triangle, and none may lie on
%       another along more than an edge of both; or `none`.
%     - rounds(N)
%       Of step 3; default 5.
%
%   OFF, OBJ and PLY have polygons; one with holes, or that meets itself, or
%   that another part of the solid touches inside, is divided into triangles. An
%   empty solid gives a file without faces, with a warning; so does one that
%   rounding leaves nothing of.
%
%   @error existence_error(segment, S),
%   geometry_error(written(faulty(S, Rounds, Fault))): Fault is one of open(N)
%   edges, undivided(N) faces, crossing(N) edges, penetrates(N, Meeting) or
%   touches(N, Meeting) as of boundary_meetings/3. No file then, nor is an old
%   one touched

write_solid(File, S) :-
    write_solid(File, S, []).

write_solid(File, S, Options) :-
    (   segment(S, _, Name0)
    ->  option(name(Name), Options, Name0)
    ;   existence_error(segment, S)
    ),
    solid_format(File, Options, Format),
    stage(write, written(Format, File, S, Name, Options)).

solid_format(File, Options, Format) :-
    file_name_extension(_, Ending0, File),
    downcase_atom(Ending0, Ending),
    option(format(Format0), Options, Ending),
    (   Format0 == pl
    ->  Format = pl
    ;   mesh_file_format(File, Options, stl),
        \+ option(binary(_), Options)
    ->  Format = stl_binary
    ;   mesh_file_format(File, Options, Format)
    ).

written(pl, File, _, _, _) :-
    !,
    write_model(File).
written(Format, File, S, Name0, Options) :-
    mesh_names(File, Format, [Name0], Names),
    format_manner(Format, Options, Manner),
    clean_boundary(S, Manner, Options, Boundary, Rounds),
    call_cleanup(
        ( mesh_to_file(File,
                       sg_solid_file:boundary_written(Boundary, Format, Names)),
          boundary_counts(Boundary, Counts)
        ),
        boundary_close(Boundary)),
    said_rounds(File, Rounds),
    said_empty(File, S, Counts).

boundary_written(Boundary, Format, Names, Stream) :-
    boundary_write(Boundary, Stream, Format, Names, Outcome),
    mesh_outcome(Outcome).

said_rounds(File, Rounds) :-
    flag(sg_solid_files, Files, Files+1),
    flag(sg_solid_rounds, Sum, Sum+Rounds),
    (   Rounds =:= 0
    ->  true
    ;   said_of(File, informational, rounds(Rounds))
    ).

said_empty(File, S, Counts) :-
    (   Counts \= counts(0, _, _, _)
    ->  true
    ;   p(S, _, _)
    ->  said_of(File, warning, collapsed)
    ;   said_of(File, warning, empty)
    ).

said_of(File, Kind, What) :-
    asked_for(File, Target),
    print_message(Kind, sanggwan(written(Target, What))).

%!  write_solids(+File, +Pairs:list, +Options:list) is det.
%
%   Write segments of the current world to one mesh file, S-Name in Pairs: each
%   solid is rounded, checked and, if need be, united with itself alone, as
%   write_solid/3 does it; what two of them have in common stays. Surfaces are
%   rounded, curves left out. Options except for name(_) as there.
%
%   @error as write_solid/3

write_solids(File, [S-Name], Options) :-
    segment(S, solid, _),
    !,
    write_solid(File, S, [name(Name)|Options]).
write_solids(File, Pairs, Options) :-
    solid_format(File, Options, Format),
    stage(write, facts_snapshot(
                     sg_solid_file:all_written(Format, File, Pairs, Options))).

all_written(Format, File, Pairs, Options) :-
    pairs_keys_values(Pairs, Ss, Names0),
    mesh_names(File, Format, Names0, Names),
    format_manner(Format, Options, Manner),
    foldl(clean_segment(Manner, Options), Ss, CleanSs, 0, Rounds),
    Manner = manner(Single, Form, Copies),
    boundary_open(CleanSs, [], Single, 0.0, Form, Copies, Boundary),
    call_cleanup(
        mesh_to_file(File, sg_solid_file:boundary_written(Boundary, Format,
                                                          Names)),
        boundary_close(Boundary)),
    said_rounds(File, Rounds).

%   clean_segment(Manner, Options, S, Clean, Rounds0, Rounds): Clean is S, or
%   what became of it in more rounds.

clean_segment(Manner, Options, S, Clean, Rounds0, Rounds) :-
    (   segment(S, solid, _),
        p(S, _, _)
    ->  clean_boundary(S, Manner, Options, Boundary, N),
        call_cleanup(rounds_kept(N, S, Boundary, Clean),
                     boundary_close(Boundary)),
        Rounds is max(Rounds0, N)
    ;   Clean = S,
        Rounds = Rounds0
    ).

rounds_kept(0, S, _, Clean) :-
    !,
    Clean = S.
rounds_kept(_, _, Boundary, Clean) :-
    fresh_id(segment, 0, Clean),
    boundary_add(Boundary, Clean),
    assert_fact(segment(Clean, solid, rounded)),
    fill_all.

%!  output_statistics(-Statistics) is det.
%
%   A dict: solids written since the process started, and the rounds these
%   needed.

output_statistics(_{solids:Solids, rounds:Rounds}) :-
    flag(sg_solid_files, Solids, Solids),
    flag(sg_solid_rounds, Rounds, Rounds).


                /*******************************
                *       ROUND, CHECK, UNITE    *
                *******************************/

%   format_manner(Format, Options, Manner): manner(Single, Form, Copies) as
%   boundary_open/7 wants them.

format_manner(Format, Options, manner(Single, Form, Copies)) :-
    (   memberchk(Format, [stl, stl_binary])
    ->  Single = true,
        Form = triangles,
        Copies = false
    ;   Single = false,
        Form = polygons,
        option(shared(Shared), Options, false),
        must_be(boolean, Shared),
        (   Shared == true
        ->  Copies = false
        ;   Copies = true
        )
    ).

%   clean_boundary(S, Manner, Options, Boundary, Rounds): Boundary has no fault,
%   after as many rounds.

clean_boundary(S, Manner, Options, Boundary, Rounds) :-
    option(check(Which), Options, changed),
    must_be(oneof([changed,all,none]), Which),
    option(rounds(Most), Options, 5),
    must_be(nonneg, Most),
    rounded(S, Manner, Boundary0),
    (   Which == none
    ->  Boundary = Boundary0,
        Rounds = 0
    ;   boundary_fault(Boundary0, Which, Fault)
    ->  boundary_close(Boundary0),
        next_round(Fault, S, 1, Most, task(S, Manner), Boundary, Rounds)
    ;   Boundary = Boundary0,
        Rounds = 0
    ).

rounded(S, manner(Single, Form, Copies), Boundary) :-
    findall(S-V, origin(S, v(V), _), Made),
    boundary_open([S], Made, Single, 0.0, Form, Copies, Boundary).

%   boundary_fault(Boundary, Which, Fault): the first fault there is.

boundary_fault(Boundary, Which, Fault) :-
    boundary_counts(Boundary, Counts),
    Counts = counts(_, Open, Crossing, Stuck),
    (   Stuck > 0
    ->  Fault = undivided(Stuck)
    ;   Open > 0
    ->  Fault = open(Open)
    ;   Crossing > 0
    ->  Fault = crossing(Crossing)
    ;   (   Which == all
        ->  All = true
        ;   All = false
        ),
        boundary_meetings(Boundary, All, Meetings),
        partition(only_touches, Meetings, Touches, Through),
        (   Through = [First|_]
        ->  length(Through, N),
            Fault = penetrates(N, First)
        ;   Touches = [First|_],
            length(Touches, N),
            Fault = touches(N, First)
        )
    ).

only_touches(meeting(self_touching, _, _, _)).

%   next_round(Fault, S, Round, Most, Task, Boundary, Rounds): S, rounded, has
%   Fault; it is united with itself, and Boundary is what comes out: with what
%   still goes through itself on a coarser grid.

next_round(Fault, _, Round, Most, task(S, _), _, _) :-
    Round > Most,
    !,
    Rounds is Round-1,
    throw(error(geometry_error(written(faulty(S, Rounds, Fault))), _)).
next_round(Fault, S0, Round, Most, Task, Boundary, Rounds) :-
    facts_snapshot(
        sg_solid_file:united_round(Fault, S0, Round, Most, Task, Boundary,
                                   Rounds)).

united_round(Fault0, S0, Round, Most, Task, Boundary, Rounds) :-
    Task = task(S, Manner),
    Manner = manner(Single, _, _),
    (   rounded_copy(S0, Single, S1)
    ->  united(S1, S2)
    ;   Fault0 = open(_)
    ->  Done is Round-1,
        throw(error(geometry_error(written(faulty(S, Done, Fault0))), _))
    ;   S1 = S0,                        % a coarser grid may still do
        S2 = S0
    ),
    in_rounds(Manner, Rounded),
    rounded(S2, Rounded, Boundary0),
    (   boundary_fault(Boundary0, all, _)
    ->  output_grid(Single, Round, S1, Grid),
        boundary_coarsen(Boundary0, Grid, Boundary1),
        boundary_close(Boundary0),
        judged(Boundary1, S2, Round, Most, Task, Boundary, Rounds)
    ;   Boundary = Boundary0,
        Rounds = Round
    ).

%   in_rounds(Manner0, Manner): what is thin may go through itself as somebody
%   else divides it, so polygons that are not quite flat go as triangles.

in_rounds(manner(Single, Form0, Copies), manner(Single, Form, Copies)) :-
    (   Form0 == polygons
    ->  Form = flat
    ;   Form = Form0
    ).

%   judged(Boundary0, S, Round, Most, Task, Boundary, Rounds): Boundary0 is what
%   came of Round.

judged(Boundary0, S, Round, Most, Task, Boundary, Rounds) :-
    (   boundary_fault(Boundary0, all, Fault)
    ->  (   closed_copy(Boundary0, Copy)
        ->  true
        ;   Copy = S
        ),
        boundary_close(Boundary0),
        Next is Round+1,
        next_round(Fault, Copy, Next, Most, Task, Boundary, Rounds)
    ;   Boundary = Boundary0,
        Rounds = Round
    ).

%   rounded_copy(S, Single, Copy): the rounded triangles as a segment, without
%   those that rounding turned over if the others close. If not, polygons go
%   as the triangles of t/6 before they are rounded: whatever rounding does to
%   triangles, they stay triangles, and closed.

rounded_copy(S, Single, Copy) :-
    (   triangle_copy(S, Single, triangles, Copy0)
    ->  Copy = Copy0
    ;   triangle_copy(S, false, soup, Triangles),
        triangle_copy(Triangles, Single, soup, Copy)
    ),
    fill_all.                           % what has no area needs none

fill_all :-
    limit_value(contacts, Most),
    fill_triangles(all, Most, _).

triangle_copy(S, Single, Form, Copy) :-
    boundary_open([S], [], Single, 0.0, Form, false, Boundary),
    call_cleanup(closed_copy(Boundary, Copy), boundary_close(Boundary)).

%   closed_copy(Boundary, Copy) is semidet: a segment, if it is closed.

closed_copy(Boundary, Copy) :-
    boundary_counts(Boundary, counts(_, 0, _, 0)),
    fresh_id(segment, 0, Copy),
    boundary_add(Boundary, Copy),
    assert_fact(segment(Copy, solid, rounded)).

%   output_grid(Single, Round, S, Grid): how coarse it is where S goes through
%   itself: 8 units (float32) or 16 (doubles) in the last place of the largest
%   coordinate, and as many times that in each round; never above 2**-12 of it.

output_grid(Single, Round, S, Grid) :-
    largest_power(S, Exponent),
    (   Single == true
    ->  Grid is 2.0**(Exponent-24+min(12, 3*Round))
    ;   Grid is 2.0**(Exponent-53+min(41, 4*Round))
    ).

%   largest_power(S, E): no coordinate of S is larger than 2**E.

largest_power(S, E) :-
    aggregate_all(max(Size),
                  ( v(S, _, X, Y, Z),
                    Size is max(abs(X), max(abs(Y), abs(Z))) ),
                  Largest),
    Start is truncate(log(Largest)/log(2))-1,
    power_above(Start, Largest, E).

%   power_above(E0, X, E): the first E from E0 on with 2**E >= X.

power_above(E0, X, E) :-
    (   2.0**E0 >= X
    ->  E = E0
    ;   E1 is E0+1,
        power_above(E1, X, E)
    ).

%   united(S, Union): Union is the solid that S bounds, no part of it inside.
%   What goes through itself by less than the tolerance counts too, so S is cut
%   by itself first.

united(S, Union) :-
    fresh_id(segment, 0, Union),
    penetrate([S-S], [tolerance(0)]),
    boolean(union([S]), Union, [tolerance(0)]).
