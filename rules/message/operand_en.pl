:- module(sg_operand_en,
          [ operand_en//2,              % +S, +Faults
            operand_notice_en//2        % +What, +S
          ]).
:- use_module(explain_words, [segment_word/2]).
:- use_module('../csg/operand_name', [operand_name_en//1]).
/** <module> What is wrong with an operand of a Boolean, in English.

operand_ko.pl has the same heads in Korean (tests/rules/solid/operand.plt).
*/

%!  operand_en(+S, +Faults)// is det.
%
%   The message for geometry_error(operand(S, Faults)).

operand_en(S, Faults) -->
    operand_en(S),
    [ ' cannot be an operand:' ],
    faults_en(Faults),
    [ nl, '  Mend it where it comes from; the option repair mends what \c
           can be mended.' ].

operand_en(S) -->
    { integer(S) },
    !,
    { segment_word(S, Name) },
    [ 'segment ~d~w'-[S, Name] ].
operand_en(Name) -->
    operand_name_en(Name).

faults_en([]) -->
    [].
faults_en([Fault|Faults]) -->
    [ nl, '  ' ],
    operand_fault_en(Fault),
    faults_en(Faults).

operand_fault_en(no_faces) -->
    [ 'it has no faces' ].
operand_fault_en(zero_volume) -->
    [ 'it has no volume' ].
operand_fault_en(open_edges(N, Edges)) -->
    [ 'it is not closed: ~D edge(s) with a face on one side only'-[N] ],
    edges_en(Edges).
operand_fault_en(unbalanced_edges(N, Edges)) -->
    [ '~D edge(s) with more faces on one side than on the other'-[N] ],
    edges_en(Edges).

edges_en([]) -->
    [].
edges_en([edge(V1, V2, [X1,Y1,Z1], [X2,Y2,Z2], N)|Edges]) -->
    [ nl, '    ~d-~d from (~6g, ~6g, ~6g) to (~6g, ~6g, ~6g), faces: ~d'-
          [V1,V2,X1,Y1,Z1,X2,Y2,Z2,N] ],
    edges_en(Edges).

%!  operand_notice_en(+What, +S)// is det.
%
%   The message for sanggwan(operand(What, S)).

operand_notice_en(inside_out, S) -->
    { segment_word(S, Name) },
    [ 'segment ~d~w is inside out, so nothing is inside it'-[S, Name], nl,
      '  Turn its polygons round; the option repair does that.' ].
operand_notice_en(surface(Faults), S) -->
    { segment_word(S, Name) },
    [ 'segment ~d~w is taken for a surface; what is outside of the solids \c
       stays of it'-[S, Name] ],
    faults_en(Faults),
    [ nl, '  If it should be a solid, mend it where it comes from; the option \c
           repair mends what can be mended.' ].
operand_notice_en(repaired(welded, N), S) -->
    [ 'segment ~d: ~D vertex(es) in the place of others welded'-[S, N] ].
operand_notice_en(repaired(no_area, N), S) -->
    [ 'segment ~d: ~D face(s) without area dropped'-[S, N] ].
operand_notice_en(repaired(duplicate, N), S) -->
    [ 'segment ~d: ~D face(s) dropped that were there twice'-[S, N] ].
operand_notice_en(repaired(turned, N), S) -->
    [ 'segment ~d: ~D shell(s) turned that were inside out'-[S, N] ].
