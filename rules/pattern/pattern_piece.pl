:- module(sg_pattern_piece,
          [ pattern_pieces/3,           % +D, +Look, -Pieces
            piece_points/2,             % +Piece, -Points
            corner_map/2                % +Shapes, -Map
          ]).
:- use_module('../kernel', [shape_at/3, shape_map_open/3]).
:- use_module('../near', [tolerance/2]).
:- use_module('../store', [e/5, joint/6, origin/3, p/3, piece/3, t/6, v/5]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, member/2, nth1/3, reverse/2]).
:- use_module(library(pairs),
              [group_pairs_by_key/2, pairs_keys_values/3, pairs_values/2]).
/** <module> The pieces of a pattern, in millimetres.

A pattern is a segment of kind `pattern`: a solid laid flat (development.pl),
each edge and polygon with the number that it has there. To be drawn it is taken
apart into pieces:

    piece(name(D,K,Part), Faces, Sides)
    face(P, Shapes)           a polygon, as convex shapes: lists of corners
    side(E, P, A, B, Joint)   one of its edges, the face on its left
    W-(X-Y)                   a corner: its vertex, and where it is, y up

Part is 0, or which part of piece K where it had to be divided. What comes
together when the model is folded says Joint:

    fold(J, Angle, Which)     with its neighbour in this piece
    seam(J, Angle, Which)     with another side with the same J
    line(J, Which)            nothing: a penetration line inside the face
    border                    nothing
    generator(N)              nothing: a generator of a true development, which
                              is no side but lies within the face

Which is 1 or 2, the two sides of a joint. Angle is in degrees, 0 flat,
positive if the pattern is folded away from the reader. J is the number of the
joint, or split(I) if the sheet and not the model made the seam.
*/

:- set_prolog_flag(optimise, true).

%!  pattern_pieces(+D, +Look, -Pieces) is det.
%
%   Pieces are those of the pattern D in the order of their numbers. Look is
%   look(Millimetres, From): how many a unit of the model is, and whether the
%   pattern is seen from `outside` or from `inside`.

pattern_pieces(D, Look, Pieces) :-
    joints(D, Joints),
    findall(K-P, polygon_piece(D, P, K), Keyed0),
    msort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Groups),
    maplist(group_piece(D, Joints, Look), Groups, Pieces0),
    findall(Generator, generator(D, Look, Generator), Generators),
    (   Generators == []
    ->  Pieces = Pieces0
    ;   maplist(piece_generators(Generators), Pieces0, Pieces)
    ).

%   A pattern without piece/3 is in one piece.

polygon_piece(D, P, K) :-
    p(D, P, _),
    (   piece(D, P, K0)
    ->  K = K0
    ;   K = 1
    ).

joints(D, Joints) :-
    findall(Pair,
            ( joint(D, J, E1, E2, Kind, Angle),
              joint_side(Kind, J, E1, E2, Angle, Pair)
            ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Joints).

joint_side(Kind, J, E1, E2, Angle, E-Joint) :-
    nth1(Which, [E1,E2], E),
    joint_term(Kind, J, Angle, Which, Joint).

joint_term(fold, J, Angle, Which, fold(J,Angle,Which)).
joint_term(seam, J, Angle, Which, seam(J,Angle,Which)).
joint_term(line, J, _, Which, line(J,Which)).

group_piece(D, Joints, Look, K-Ps, piece(name(D,K,0),Faces,Sides)) :-
    maplist(polygon_face(D, Look), Ps, Faces),
    findall(Side,
            ( member(P, Ps), polygon_side(D, Joints, Look, P, Side) ),
            Sides).

polygon_face(D, Look, P, face(P,Shapes)) :-
    findall(Shape,
            ( t(D, P, _, W1, W2, W3),
              maplist(corner(D, Look), [W1,W2,W3], Shape0),
              seen_shape(Look, Shape0, Shape)
            ),
            Shapes).

corner(D, look(Factor,From), W, W-(X-Y)) :-
    v(D, W, X0, Y0, _),
    (   From == inside
    ->  X is -X0*Factor
    ;   X is X0*Factor
    ),
    Y is Y0*Factor.

seen_shape(look(_,inside), Shape0, Shape) :-
    !,
    reverse(Shape0, Shape).
seen_shape(_, Shape, Shape).

%   Edges that only divide a polygon belong to nothing that is drawn.

polygon_side(D, Joints, Look, P, side(E,P,A,B,Joint)) :-
    once(p(D, P, Es)),
    member(E, Es),
    e(D, E, V1, V2, Et),
    (   get_assoc(E, Joints, Joint0)
    ->  true
    ;   Et =:= 1,
        Joint0 = border
    ),
    maplist(corner(D, Look), [V1,V2], [A0,B0]),
    seen_side(Look, A0, B0, Joint0, A, B, Joint).

%   From inside the pattern is a mirror image: a side runs the other way, and
%   what folds away folds up.

seen_side(look(_,inside), A, B, Joint0, B, A, Joint) :-
    !,
    turned_joint(Joint0, Joint).
seen_side(_, A, B, Joint, A, B, Joint).

turned_joint(fold(J,Angle0,Which), Joint) =>
    Angle is -Angle0,
    Joint = fold(J,Angle,Which).
turned_joint(seam(J,Angle0,Which), Joint) =>
    Angle is -Angle0,
    Joint = seam(J,Angle,Which).
turned_joint(Joint0, Joint) =>
    Joint = Joint0.

%   Generators are edges of no polygon (true_pattern.pl).

generator(D, Look, generator(E,A,B,N)) :-
    origin(D, e(E), generator(N,_,_,_,_)),
    e(D, E, V1, V2, _),
    maplist(corner(D, Look), [V1,V2], [A,B]).

piece_generators(Generators, piece(Name,Faces,Sides0),
                 piece(Name,Faces,Sides)) :-
    findall(P-Shape,
            ( member(face(P,Shapes), Faces), member(Shape, Shapes) ),
            Pairs),
    pairs_keys_values(Pairs, Ps0, All),
    corner_map(All, Map),
    compound_name_arguments(Ps, polygons, Ps0),
    findall(side(E,P,A,B,generator(N)),
            ( member(generator(E,A,B,N), Generators),
              middle(A, B, Middle),
              shape_at(Map, Middle, I),
              arg(I, Ps, P)
            ),
            New),
    append(Sides0, New, Sides).

middle(_-(XA-YA), _-(XB-YB), X-Y) :-
    X is (XA+XB)/2,
    Y is (YA+YB)/2.

%!  corner_map(+Shapes, -Map) is det.
%
%   Map, of shape_map_open/3, has Shapes, lists of corners.

corner_map(Shapes, Map) :-
    tolerance(paper, Near),
    maplist(pairs_values, Shapes, Pointss),
    shape_map_open(Pointss, Near, Map).

%!  piece_points(+Piece, -Points) is det.
%
%   Points, X-Y, are all corners of Piece, some of them twice.

piece_points(piece(_,Faces,_), Points) :-
    findall(Point,
            ( member(face(_,Shapes), Faces),
              member(Shape, Shapes),
              member(_-Point, Shape)
            ),
            Points).
