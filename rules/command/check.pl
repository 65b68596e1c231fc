:- module(sg_check,
          [ check_report/1,             % -Report
            report_faults/2             % +Report, ?Faults
          ]).
:- use_module('../gluing/regions', [regions_report/2, law_fault/3]).
:- use_module('../model/integrity',
              [defect_weight/2, model_defect/1, no_defect/2, shell_defect/3]).
:- use_module('../gluing/unglue', [meetings_unmeant/2]).
:- use_module('../kernel', [census/1, self_meetings/2]).
:- use_module('../model/formula_rows', [default_of/2, written_fact/2]).
:- use_module('../model/parameter_about', [about_text/3, range_of/4]).
:- use_module('../store', [segment/3, param/2]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [ append/2, max_list/2, member/2, min_list/2, selectchk/3,
                sum_list/2 ]).
/** <module> The report of `check`: what a model holds, and its faults.

A report is a dict; report.pl prints it as text or as JSON:

    _{parameters: [Parameter, ...], segments: [Segment, ...], total: Total,
      faults: N, remarks: M}

A Parameter has name, value, formula (what it is made from, as text), default
(what its file has, as text, if it was set), minimum, maximum, step, and text:
what it is, by language. What is not there is null.

Segment has segment, name, kind, vertices, half_edges, edges, polygons,
triangles, curve_edges, box ([[X1,Y1,Z1],[X2,Y2,Z2]]), area, volume (null unless
a solid), length (of curves), border_edges, shells, faults and remarks (dicts of
counts), meetings: the first places where the segment goes through itself, dicts
of kind, polygons ([P1,P2]) and at ([X,Y,Z]); faults and remarks count them all.
A shell has polygon (its first), vertices, edges, polygons, closed, euler, genus
(null unless a closed manifold), area, volume and depth: how many other
closed shells of its segment go round it. Of `cells` shells are left to the verb
cells; broken_law and unsure_part are faults of theirs. Model units.
*/

%!  check_report(-Report) is det.
%
%   Report on the current world.

check_report(Report) :-
    census(Parts),
    (   segment(_, cells, _)
    ->  meetings_unmeant(3, Selves0)
    ;   self_meetings(3, Selves0)
    ),
    findall(S-Self, ( member(Self, Selves0), arg(1, Self, S) ), Pairs),
    list_to_assoc(Pairs, Selves),
    maplist(part_report(Selves), Parts, Segments),
    sum_of(fault_count, Segments, Faults),
    sum_of(remark_count, Segments, Remarks),
    total(Segments, Total),
    parameters(Parameters),
    Report = _{parameters:Parameters, segments:Segments, total:Total,
               faults:Faults, remarks:Remarks}.

parameters(Parameters) :-
    findall(Parameter,
            ( param(Name, Value), parameter(Name, Value, Parameter) ),
            Parameters).

parameter(Name, Value,
          _{ name:Name, value:Value, formula:Formula, default:Default,
             minimum:Minimum, maximum:Maximum, step:Step, text:Texts }) :-
    parameter_formula(Name, Formula),
    (   default_of(Name, Written)
    ->  formula_text(Written, Default)
    ;   Default = null
    ),
    range_of(Name, Least, Most, By),
    maplist(or_null, [Least,Most,By], [Minimum,Maximum,Step]),
    findall(Language-Text, about_text(Name, Language, Text), Pairs),
    (   Pairs == []
    ->  Texts = null
    ;   dict_pairs(Texts, _, Pairs)
    ).

or_null(Value0, Value) :-
    (   Value0 == none
    ->  Value = null
    ;   Value = Value0
    ).

parameter_formula(Name, Formula) :-
    param(Name, Value),
    written_fact(param(Name, Value), param(_, Written)),
    (   Written == Value
    ->  Formula = null
    ;   formula_text(Written, Formula)
    ).

formula_text(Written, Text) :-
    format(string(Text), '~W', [Written, [quoted(true),numbervars(false)]]).

%!  report_faults(+Report, ?Faults) is semidet.
%
%   Faults is the number of faults in Report.

report_faults(Report, Report.faults).

:- meta_predicate sum_of(2, +, -).

sum_of(Of, Segments, Sum) :-
    maplist(Of, Segments, Counts),
    sum_list(Counts, Sum).

fault_count(Segment, N) :-
    dict_sum(Segment.faults, N).
remark_count(Segment, N) :-
    dict_sum(Segment.remarks, N).

dict_sum(Dict, Sum) :-
    dict_pairs(Dict, _, Pairs),
    findall(N, member(_-N, Pairs), Ns),
    sum_list(Ns, Sum).

part_report(Selves,
            part(S, counts(Vs, Hs, Es, Ps, Ts, Cs), box(X1,Y1,Z1,X2,Y2,Z2),
                 Area, Volume0, Length, Shells0, Defects0), Report) :-
    segment_kind(S, Kind, Name),
    get_assoc(S, Selves, self(_, SelfCounts, Meetings0)),
    maplist(meeting_report, Meetings0, Meetings),
    (   memberchk(border_edge-Border, Defects0)
    ->  true
    ;   Border = 0
    ),
    meant_left_out(Kind, S, Defects0, Meant),
    findall(D, own_defect(Kind, Volume0, Meant, D), Defects1),
    shell_defects(Kind, Shells0, ShellCounts),
    region_defects(Kind, S, Defects0, RegionCounts),
    append([Defects1,SelfCounts,ShellCounts,RegionCounts], Defects),
    weighed(fault, Defects, Faults),
    weighed(remark, Defects, Remarks),
    (   Kind == solid
    ->  Volume = Volume0
    ;   Volume = null
    ),
    (   Kind == cells
    ->  Shells = []
    ;   maplist(shell_report(Defects0), Shells0, Shells)
    ),
    Report = _{segment:S, name:Name, kind:Kind, vertices:Vs, half_edges:Hs,
               edges:Es, polygons:Ps, triangles:Ts, curve_edges:Cs,
               box:[[X1,Y1,Z1], [X2,Y2,Z2]], area:Area, volume:Volume,
               length:Length, border_edges:Border, shells:Shells,
               faults:Faults, remarks:Remarks, meetings:Meetings}.

meeting_report(meeting(Kind, P1, P2, X, Y, Z),
               _{kind:Kind, polygons:[P1,P2], at:[X,Y,Z]}).

segment_kind(S, Kind, Name) :-
    (   segment(S, Kind0, Term)
    ->  Kind = Kind0,
        format(string(Name), '~w', [Term])
    ;   Kind = unknown,
        Name = ""
    ).

%   meant_left_out(Kind, S, Counts0, Counts): faces that were parted are there
%   twice.

meant_left_out(cells, S, Counts0, Counts) :-
    selectchk(duplicate_face-_, Counts0, Counts1),
    !,
    aggregate_all(count, model_defect(duplicate_face(S, _, _)), N),
    (   N =:= 0
    ->  Counts = Counts1
    ;   Counts = [duplicate_face-N|Counts1]
    ).
meant_left_out(_, _, Counts, Counts).

%   own_defect(Kind, Volume, Counts, D): the counts with the names and meaning
%   of integrity.pl.

own_defect(Kind, _, Counts, Name-N) :-
    member(Name0-N, Counts),
    \+ no_defect(Kind, Name0),
    (   Name0 == border_edge
    ->  Name = open_edge
    ;   Name = Name0
    ).
own_defect(solid, Volume, _, inside_out-1) :-
    Volume < 0.0.

shell_defects(Kind, Shells, Counts) :-
    length(Shells, Several),
    findall(Name-N,
            ( Kind == solid,
              member(Name, [nested_shell,turned_shell]),
              aggregate_all(count,
                            ( member(Shell, Shells),
                              shell_defect(Name, Several, Shell) ),
                            N),
              N > 0 ),
            Counts).

%   region_defects(Kind, S, Defects, Counts): what regions say, if polygons are
%   faces.

region_defects(cells, S, Defects, Counts) :-
    \+ memberchk(open_polygon-_, Defects),
    \+ memberchk(wrong_triangles-_, Defects),
    !,
    regions_report(S, Report),
    findall(Name-N, law_fault(Report, Name, N), Counts).
region_defects(_, _, _, []).

weighed(Weight, Defects, Dict) :-
    findall(Name-N, ( member(Name-N, Defects), defect_weight(Name, Weight) ),
            Pairs),
    dict_pairs(Dict, _, Pairs).

shell_report(Defects, shell(P, Vs, Es, Ps, Euler0, Closed, Pinched, Area,
                            Volume, Depth), Report) :-
    (   ( memberchk(turned_edge-_, Defects)
        ; memberchk(nonmanifold_edge-_, Defects)
        ; memberchk(touching_edge-_, Defects)
        ; memberchk(open_polygon-_, Defects)
        )
    ->  Euler = null
    ;   Euler = Euler0
    ),
    (   Closed == true,
        Pinched == false,
        integer(Euler),
        Euler mod 2 =:= 0
    ->  Genus is (2-Euler)//2
    ;   Genus = null
    ),
    Report = _{polygon:P, vertices:Vs, edges:Es, polygons:Ps, closed:Closed,
               euler:Euler, genus:Genus, area:Area, volume:Volume,
               depth:Depth}.

total(Segments, Total) :-
    maplist(sum_key(Segments),
            [vertices,edges,polygons,triangles], [Vs,Es,Ps,Ts]),
    sum_key(Segments, area, Area),
    length(Segments, N),
    box_of(Segments, Box),
    Total = _{segments:N, vertices:Vs, edges:Es, polygons:Ps, triangles:Ts,
              area:Area, box:Box}.

sum_key(Segments, Key, Sum) :-
    findall(N, ( member(S, Segments), get_dict(Key, S, N) ), Ns),
    sum_list(Ns, Sum).

box_of([], null) :-
    !.
box_of(Segments, [Low, High]) :-
    findall(L, ( member(S, Segments), [L,_] = S.box ), Lows),
    findall(H, ( member(S, Segments), [_,H] = S.box ), Highs),
    columns(min_list, Lows, Low),
    columns(max_list, Highs, High).

columns(Pick, Rows, [X,Y,Z]) :-
    findall(A, member([A,_,_], Rows), As),
    findall(B, member([_,B,_], Rows), Bs),
    findall(C, member([_,_,C], Rows), Cs),
    call(Pick, As, X),
    call(Pick, Bs, Y),
    call(Pick, Cs, Z).
