:- encoding(utf8).
:- module(sg_verbs_glue,
          [ glue_run/3,                 % +Files, +Options, -Status
            unglue_run/3,               % +Files, +Options, -Status
            glue_misses_told/0
          ]).
:- use_module('../csg/csg', [glue_operands/2, node/4, root_segment/1]).
:- use_module('../csg/csg_roots', [roots_alone/0]).
:- use_module('../gluing/exploded', [cells_parted/1]).
:- use_module('../gluing/gap', [gap_reach/2]).
:- use_module('../gluing/glue_choice', [choice_made/1]).
:- use_module('../gluing/regions', [regions_made/2, regions_report/2]).
:- use_module('../gluing/unglue',
              [unglued_between/4, unglued_polygons/3, unglued_region/4]).
:- use_module('../json_layout', [json_laid_out/3]).
:- use_module('../kernel', [census/1]).
:- use_module('../model/model', [load_model/2, save_model/1]).
:- use_module('../plain', [plain_json/2]).
:- use_module('../language', [language/1]).
:- use_module('../solid/glue',
              [unglue/1, glue_report/2, glue_misses/2]).
:- use_module('../solid/glue_contact', [contact/4, contact_counts/2]).
:- use_module('../store',
              [ v/5, segment/3, region/3, sides/4, from_p/5, from_r/4,
                assert_fact/1, facts_snapshot/1, facts_transaction/1 ]).
:- use_module(solid_verbs, [operands_loaded/4, operands_evaluated/2]).
:- use_module(verb_output,
              [ some_files/2, outputs/3, some_outputs/1, no_model_replaced/2,
                output_written/2, reported/2, summary_sent_told/2
              ]).
:- use_module(verbs_cells, [print_cells/3, print_totals/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists), [max_list/2, member/2, nth1/3]).
:- use_module(library(option), [option/2]).
:- use_module(library(ordsets), [list_to_ord_set/2, ord_memberchk/2]).
/** <module> The verbs glue and unglue.

What is glued is a node of the CSG tree, and its operands are there beside it:
so that is what is written, and taking it apart again only takes the node away.
*/

%!  glue_run(+Files, +Options, -Status) is det.
%
%   As verb_run/4. The roots of all files are the operands. The report is a dict
%   as of cells_run/3, and before: the counts of the operands together, and
%   contacts: how many of each kind. What is written are the operands as they
%   were read, and the glue. With 'dry-run'(true) nothing is; then the report
%   has each contact, and where operands come near each other (glue_misses/2).

glue_run(Files, Options, 0) :-
    some_files(Files, 'MODEL'),
    outputs(Options, [pl], Outputs),
    no_model_replaced(Files, Outputs),
    operands_loaded(glue, Files, Options, Sources),
    once(root_segment(S)),
    forall(wished(Options, Wish), assert_fact(gluing(S, Wish))),
    facts_snapshot(( operands_evaluated(Sources, Options),
                     report(S, Options, Report) )),
    (   option('dry-run'(true), Options)
    ->  printed(Options, Report)
    ;   reported(Outputs, sg_verbs_glue:printed(Options, Report)),
        summary_sent_told(Outputs, [pl]),
        maplist(output_written(save_model), Outputs)
    ).

wished(Options, only(What)) :-
    option(only(What), Options).
wished(Options, tolerance(T)) :-
    option(tolerance(T), Options).

%   report(S, Options, Report): of the glue S, which is the only root.

report(S, Options, Report) :-
    glue_report(S, Report0),
    mended_warned(S),
    overlaps_warned(S, Report0),
    closed_surfaces_warned(S),
    operand_counts(S, Before),
    contact_counts(S, Contacts),
    Report1 = Report0.put(_{ segment:S, name:"glue", faults:_{},
                             before:Before, contacts:Contacts }),
    (   untouched(Before, Report1.counts),
        \+ choice_made(S)
    ->  print_message(informational, sanggwan(glue_apart(S)))
    ;   true
    ),
    glue_misses(S, Misses),
    (   option('dry-run'(true), Options)
    ->  findall(Contact, contact_dict(S, Contact), Each),
        maplist(miss_dict, Misses, Gaps),
        Report = Report1.put(_{each_contact:Each, misses:Gaps})
    ;   Report = Report1
    ),
    misses_warned(S, Misses).

contact_dict(S, _{ kind:Kind, segment1:S1, place1:Text1, segment2:S2,
                   place2:Text2 }) :-
    contact(S, Kind, seat(S1,_,Place1), seat(S2,_,Place2)),
    place_text(Place1, Text1),
    place_text(Place2, Text2).

place_text(vertex(V), Text) :-
    format(string(Text), "v(~d)", [V]).
place_text(edge(A,B), Text) :-
    format(string(Text), "e(~d,~d)", [A, B]).
place_text(face(P,_), Text) :-
    format(string(Text), "p(~d)", [P]).

miss_dict(miss(S1-_,S2-_,Gap,p(X,Y,Z)-_),
          _{segment1:S1, segment2:S2, distance:Gap, at:[X,Y,Z]}).

%   mended_warned(S): of operands of S what was there twice is there once, and
%   what was inside out is not any more.

mended_warned(S) :-
    glue_operands(S, Operands),
    list_to_ord_set(Operands, Set),
    census(Parts),
    forall(( member(Part, Parts),
             arg(1, Part, S0),
             ord_memberchk(S0, Set),
             mended(S0, Part, What, N) ),
           print_message(warning, sanggwan(operand(repaired(What, N), S0)))).

mended(S0, part(_,_,_,_,Volume,_,Shells,_), turned, N) :-
    Volume < 0.0,
    once(segment(S0, solid, _)),
    length(Shells, N).
mended(S0, part(_,_,_,_,_,_,_,Defects), What, N) :-
    \+ segment(S0, cells, _),
    member(Kind-What, [twin_vertices-welded,duplicate_face-duplicate]),
    memberchk(Kind-N, Defects).

%!  glue_misses_told is det.
%
%   Warnings of where operands of the glues that are roots overlap, and of where
%   they come near each other and were not glued: of three pairs each, and how
%   many more.

glue_misses_told :-
    forall(( root_segment(S), node(S, glue, _, _) ),
           ( overlaps_warned(S),
             closed_surfaces_warned(S),
             glue_misses(S, Misses),
             misses_warned(S, Misses) )).

overlaps_warned(S) :-
    (   from_r(S, R, S1, _),
        from_r(S, R, S2, _),
        S1 < S2
    ->  glue_report(S, Report),
        overlaps_warned(S, Report)
    ;   true
    ).

%   overlaps_warned(S, Report): of those that are so thin that noise may have
%   made them, it is said what to give.

overlaps_warned(S, Report) :-
    findall(Region,
            ( member(Region, Report.regions), Region.inside = [_,_|_] ),
            Overlaps),
    forall(( nth1(I, Overlaps, Region), I =< 3 ), overlap_warned(S, Region)),
    length(Overlaps, N),
    More is N-3,
    (   More > 0
    ->  print_message(warning, sanggwan(glue_overlaps(S, More)))
    ;   true
    ),
    findall(Thickness,
            ( member(Region, Overlaps), thin(S, Region, Thickness) ),
            Thin),
    (   max_list(Thin, Most)
    ->  length(Thin, Many),
        print_message(warning, sanggwan(glue_thin(S, Many, Most)))
    ;   true
    ).

%   closed_surfaces_warned(S): a surface among the operands that encloses a
%   region by itself is most likely meant to be a solid. As none it is inside
%   nothing: the region is a void.

closed_surfaces_warned(S) :-
    findall(R-S0, closed_by(S, R, S0), Found),
    forall(( nth1(I, Found, R-S0), I =< 3 ),
           print_message(warning, sanggwan(glue_surface(S, R, S0)))),
    length(Found, N),
    More is N-3,
    (   More > 0
    ->  print_message(warning, sanggwan(glue_surfaces(S, More)))
    ;   true
    ).

closed_by(S, R, S0) :-
    region(S, R, void),
    once(side(S, R, First)),
    from_p(S, First, S0, _, _),
    once(segment(S0, surface, _)),
    forall(side(S, R, P), once(from_p(S, P, S0, _, _))).

side(S, R, P) :-
    sides(S, P, R, _).
side(S, R, P) :-
    sides(S, P, _, R).

overlap_warned(S, Region) :-
    Region.inside = [S1,S2|_],
    print_message(warning,
                  sanggwan(glue_overlap(S, S1, S2, Region.region,
                                        Region.volume))).

thin(S, Region, Thickness) :-
    gap_reach(S, Reach),
    Thickness is 2*Region.volume/Region.area,
    Thickness =< Reach.

misses_warned(S, Misses) :-
    forall(( nth1(I, Misses, miss(S1-_,S2-_,Gap,End-_)), I =< 3 ),
           print_message(warning,
                         sanggwan(glue_gap(S, S1, S2, Gap, End)))),
    length(Misses, N),
    More is N-3,
    (   More > 0
    ->  print_message(warning, sanggwan(glue_gaps(S, More)))
    ;   true
    ).

untouched(Before, After) :-
    forall(member(Key, [vertices,edges,faces,parts]),
           Before.Key =:= After.Key).

%   operand_counts(S, Counts): of all operands together, apart.

operand_counts(S, Counts) :-
    glue_operands(S, Operands),
    counts_zero(Zero),
    foldl(counts_added, Operands, Zero, Counts).

counts_zero(_{ vertices:0, edges:0, faces:0, loops:0, parts:0, regions:1,
               shells:0, genus:0 }).

counts_added(Operand, Counts0, Counts) :-
    regions_report(Operand, Report),
    findall(Key-N,
            ( get_dict(Key, Counts0, N0),
              N1 = Report.counts.Key,
              (   Key == regions
              ->  N is N0+N1-1
              ;   N is N0+N1
              ) ),
            Pairs),
    dict_pairs(Counts, _, Pairs).

printed(Options, Report) :-
    (   option(json(true), Options)
    ->  plain_json(current_output,
                   json_laid_out(current_output, Report, 78)),
        nl
    ;   language(Language),
        print_totals(Language, before, Report.before),
        print_contacts(Language, Report.contacts),
        forall(member(Contact, Report.get(each_contact, [])),
               print_contact(Language, Contact)),
        forall(member(Miss, Report.get(misses, [])),
               print_miss(Language, Miss)),
        print_cells(Language, Options, Report)
    ).

print_contacts(_, []) :-
    !.
print_contacts(Language, Contacts) :-
    findall(Text,
            ( member(Contact, Contacts),
              kind_text(Language, Contact.kind, Kind),
              format(string(Text), "~w ~D", [Kind, Contact.count]) ),
            Texts),
    atomic_list_concat(Texts, ', ', All),
    word(contacts, Language, Word),
    format("~w: ~w~n", [Word, All]).

print_contact(Language, Contact) :-
    kind_text(Language, Contact.kind, Kind),
    format("  ~w: ~d-~w, ~d-~w~n",
           [ Kind, Contact.segment1, Contact.place1, Contact.segment2,
             Contact.place2 ]).

print_miss(Language, Miss) :-
    word(miss, Language, Word),
    Miss.at = [X,Y,Z],
    format("  ~w: ~d, ~d, ~6g (~6g, ~6g, ~6g)~n",
           [Word, Miss.segment1, Miss.segment2, Miss.distance, X, Y, Z]).

kind_text(en, Kind, Kind).
kind_text(ko, Kind, Text) :-
    atomic_list_concat(Names, -, Kind),
    findall(Word, ( member(Name, Names), word(Name, ko, Word) ), Words),
    atomic_list_concat(Words, -, Text).

word(contacts, en, contacts).
word(contacts, ko, '접촉').
word(miss, en, 'near miss').
word(miss, ko, '닿지 않은 틈').
word(vertex, ko, '꼭짓점').
word(edge, ko, '모서리').
word(face, ko, '면').

%!  unglue_run(+Files, +Options, -Status) is det.
%
%   As verb_run/4: the roots that are glues are taken away, so their operands
%   are roots again, as they were. Of cells that have no operands, as those of a
%   file of rows, each becomes a solid. With the options region(R), face(P) and
%   between(Text) the only cells are unglued in part, and stay without operands.

unglue_run(Files, Options, 0) :-
    some_files(Files, 'MODEL'),
    outputs(Options, [pl], Outputs),
    some_outputs(Outputs),
    no_model_replaced(Files, Outputs),
    findall(Part, part_asked(Options, Part), Parts),
    (   Parts = [Part1,Part2|_]
    ->  arg(1, Part1, Option1),
        arg(1, Part2, Option2),
        usage_error(both_options(Option1, Option2))
    ;   Parts = [part(_,Part)]
    ->  part_unglued(Files, Options, Part)
    ;   all_unglued(Files, Options)
    ),
    maplist(output_written(save_model), Outputs).

part_asked(Options, part('--region',region(R))) :-
    option(region(R), Options).
part_asked(Options, part('--face',face(P))) :-
    option(face(P), Options).
part_asked(Options, part('--between',between(R1,R2))) :-
    option(between(Text), Options),
    (   split_string(Text, ",", " ", [Text1,Text2]),
        number_string(R1, Text1),
        number_string(R2, Text2),
        integer(R1),
        integer(R2)
    ->  true
    ;   usage_error(bad_value('--between', Text, 'R1,R2'))
    ).

usage_error(What) :-
    throw(error(usage_error(What), _)).

part_unglued(Files, Options, Part) :-
    load_model(Files, Options),
    roots_alone,
    findall(S, segment(S, cells, _), Ss),
    (   Ss = [S]
    ->  facts_transaction(sg_verbs_glue:unglued_part(Part, S))
    ;   length(Ss, N),
        throw(error(geometry_error(part_glue(one_cells(N))), _))
    ).

unglued_part(Part, S) :-
    (   region(S, _, _)
    ->  true
    ;   regions_made(S, _)
    ),
    part_parted(Part, S).

part_parted(region(R), S) :-
    unglued_region(S, R, _, _).
part_parted(face(P), S) :-
    unglued_polygons(S, [P], _).
part_parted(between(R1,R2), S) :-
    unglued_between(S, R1, R2, _).

all_unglued(Files, Options) :-
    load_model(Files, [evaluate(false),triangles(false)|Options]),
    findall(S, ( root_segment(S), node(S, glue, _, _) ), Glues),
    findall(S, ( segment(S, cells, _), v(S, _, _, _, _),
                 \+ node(S, glue, _, _) ),
            Alone0),
    sort(Alone0, Alone),
    (   Glues == [],
        Alone == []
    ->  print_message(warning, sanggwan(nothing_glued))
    ;   facts_transaction(( maplist(unglue, Glues),
                            maplist(sg_verbs_glue:parted, Alone) ))
    ).

parted(S) :-
    cells_parted(S),
    findall(N, segment(N, solid, region(S, _)), Ns),
    length(Ns, Cells),
    print_message(informational, sanggwan(cells_parted(S, Cells))).
