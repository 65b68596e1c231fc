:- module(sg_surface_look,
          [ surface_look/4,             % +R, +S, +Face, -Look
            look_source/5,              % +R, +S, +Face, ?Property, -Segment
            scene_looks/4,              % +Scene, +Colours, -Looks, -Leaves
            look_opacity/2,             % +Look, -Opacity
            scene_opacities/2,          % +Scene, -Opaque
            layer_shares/3,             % +Layers, +Opaque, -Shares
            face_opacity/4,             % +Opaque, +Leaf, +F, -A
            line_layers/3               % +Scene, +Y, -Layers
          ]).
:- use_module('../csg/csg', [node/4]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../kernel', [shading_layers/5]).
:- use_module('../model/look_term', [property_slot/2]).
:- use_module('../store', [look/2]).
:- use_module(group_owner, [owners_asked/2]).
:- use_module(shading_scene, [scene_handle/2, scene_leaf/2, scene_root/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [empty_assoc/1, get_assoc/3, list_to_assoc/2]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(pairs), [pairs_values/2]).
:- use_module(library(lists),
              [ append/2, append/3, list_to_set/2, member/2, nth0/3, nth1/3,
                selectchk/3 ]).
:- use_module(library(ordsets), [ord_add_element/3, ord_memberchk/2]).
/** <module> How a face looks (CB-8).

A look is a list of properties, those of look/2. Of each the nearest wins: that
of the segment of the leaf, of the nodes above it, of the root; of one segment
first that of the face. What is taken
away shows the body that it was taken from: behind the operands of a difference
but the first one comes the first one, before the node itself. Without any
colour a face has that of a palette, by roots.
*/

:- decision(surface_look/4, "How a face of a leaf looks in a shaded picture").

%!  surface_look(+R, +S, +Face, -Look:list) is semidet.
%
%   True when the Face, as in face_of/3, of segment S (0: of none), a leaf of
%   the root R, has the properties Look: colour(C), opacity(A), shine(F,N), as
%   in look/2; and hatched, which the face of a section is. Where it fails, or
%   Look has no colour(C), the palette has one. A decision, asked once for each
%   face before a picture is made.

surface_look(R, S, Face, Look) :-
    findall(Property, look_source(R, S, Face, Property, _), All),
    nearest(All, [], Look0),
    (   Face == section
    ->  Look = [hatched|Look0]
    ;   Look = Look0
    ).

%   nearest(All, Slots, Look): of those with one slot the first.

nearest([], _, []).
nearest([Property|All], Slots, Look) :-
    property_slot(Property, Slot),
    (   memberchk(Slot, Slots)
    ->  nearest(All, Slots, Look)
    ;   Look = [Property|Look1],
        nearest(All, [Slot|Slots], Look1)
    ).

%!  look_source(+R, +S, +Face, ?Property, -Segment) is nondet.
%
%   True when the Face of leaf S (0: of none) of the root R may have the
%   Property, for Segment has it; the nearest first.

look_source(R, S, Face, Property, Segment) :-
    look(_, _),
    !,
    (   S =:= 0
    ->  N = R
    ;   N = S
    ),
    seen_way(R, N, Way),
    member(Segment, Way),
    own_look(Segment, Face, Property).

own_look(Segment, Face, Property) :-
    look(Segment, face(Face, Property)).
own_look(Segment, _, Property) :-
    look(Segment, Property),
    Property \= face(_, _).

%   seen_way(R, S, Way): the segments whose look S may have, the nearest first.

seen_way(R, R, Way) :-
    !,
    body_way(R, Way).
seen_way(R, S, Way) :-
    once(way_down(R, S, Way)).

way_down(S, S, [S]).
way_down(N, S, Way) :-
    node(N, Operation, Children, _),
    nth0(I, Children, Child),
    integer(Child),
    way_down(Child, S, Way0),
    (   I > 0,
        takes_away(Operation),
        Children = [Body|_],
        integer(Body)
    ->  body_way(Body, Bodies),
        append([Way0,Bodies,[N]], Way)
    ;   append(Way0, [N], Way)
    ).

takes_away(difference).
takes_away(split(_)).
takes_away(split(_, _)).

%   body_way(N, Way): N, its first operand, the first one of that, ...

body_way(N, [N|Way]) :-
    (   node(N, Operation, [Child|_], _),
        Operation \== leaf,
        integer(Child)
    ->  body_way(Child, Way)
    ;   Way = []
    ).

%!  scene_looks(+Scene, +Colours, -Looks, -Leaves) is det.
%
%   Looks are the looks that Scene has, each once. Leaves has for each leaf the
%   places in Looks, from 0: the leaf's, then those of its faces, where a rule
%   tells them apart. Colours is `root` or `leaf`: by what the palette goes.
%
%   @error model_error(look(no_face(S, Face, Names))): a fact look/2 is of a
%          Face that S has not, nor a leaf below it; Names are those it has

scene_looks(Scene, Colours, Looks, Leaves) :-
    findall(R, scene_root(Scene, root(R,_)), Roots),
    findall(Leaf, scene_leaf(Scene, Leaf), All),
    forall(look(S, face(Face, _)), face_is_there(S, Face, All)),
    (   decision_is_default(surface_look/4),
        \+ look(_, _)
    ->  Asked = nothing
    ;   decision_is_default(surface_look/4)
    ->  Asked = leaves
    ;   Asked = faces
    ),
    (   Asked == leaves
    ->  root_ways(Roots, Ways)
    ;   empty_assoc(Ways)
    ),
    maplist(leaf_looks(Asked, Colours, Roots, Ways), All, Own),
    append(Own, Every),
    list_to_set(Every, Looks),
    maplist(look_places(Looks), Own, Leaves).

look_places(Looks, Own, Places) :-
    maplist(look_place(Looks), Own, Places).

look_place(Looks, Look, Place) :-
    once(nth0(Place, Looks, Look)).

%   root_ways(Roots, Ways): assoc from R/S to what seen_way/3 says of segment S
%   below the root R, all in one walk.

root_ways(Roots, Ways) :-
    findall(R/S-Way, ( member(R, Roots), below(R, [], S, Way), S \== R ),
            Pairs0),
    sort(1, @<, Pairs0, Pairs),         % of each the first
    list_to_assoc(Pairs, Ways).

%   below(N, Above, S, Way): S is N, or below it; Above is the way from N up.

below(S, Above, S, [S|Above]).
below(N, Above, S, Way) :-
    node(N, Operation, Children, _),
    nth0(I, Children, Child),
    integer(Child),
    (   I > 0,
        takes_away(Operation),
        Children = [Body|_],
        integer(Body)
    ->  body_way(Body, Bodies),
        append(Bodies, [N|Above], Above1)
    ;   Above1 = [N|Above]
    ),
    below(Child, Above1, S, Way).

%   leaf_looks(Asked, Colours, Roots, Ways, Leaf, Looks)

leaf_looks(leaves, Colours, Roots, Ways, leaf(Number,R,S,_,Faces),
           [Look|Looks]) :-
    Faces \= [1-section],
    get_assoc(R/S, Ways, Way),
    !,
    own_colour(Colours, Number, R, Roots, _, Colour),
    way_look(Way, any, Colour, Look),
    (   member(N, Way),
        look(N, face(_, _))
    ->  findall(Own, ( face_names(1, Faces, Face),
                       way_look(Way, Face, Colour, Own) ), Looks)
    ;   Looks = []                      % faces look alike
    ).
leaf_looks(Asked, Colours, Roots, _, leaf(Number,R,S,_,Faces), Looks) :-
    own_colour(Colours, Number, R, Roots, Place, Colour),
    asked_looks(Asked, R, S, Faces, Place-Colour, Looks).

way_look(Way, Face, Colour, Look) :-
    findall(Property, ( member(N, Way), own_look(N, Face, Property) ), All),
    nearest(All, [], Look0),
    with_colour(Look0, Colour, Look).

%   face_is_there(S, Face, Leaves): segment S, if it is one of Leaves or above
%   some, has such a Face.

face_is_there(S, Face, Leaves) :-
    under([S], [], Under),
    findall(Faces,
            ( member(leaf(_,_,Leaf,_,Faces), Leaves),
              ord_memberchk(Leaf, Under) ),
            Own),
    (   Own == []
    ->  true
    ;   append(Own, All),
        pairs_values(All, Names0),
        sort(Names0, Names),
        (   memberchk(Face, Names)
        ->  true
        ;   throw(error(model_error(look(no_face(S,Face,Names))), _))
        )
    ).

%   under(Segments, Under0, Under): Under0, ascending, and what is in the trees
%   of Segments, each once.

under([], Under, Under).
under([S|Segments], Under0, Under) :-
    (   ord_memberchk(S, Under0)
    ->  Under1 = Under0
    ;   ord_add_element(Under0, S, Under2),
        findall(Child,
                ( node(S, _, Children, _),
                  member(Child, Children),
                  integer(Child) ),
                Below),
        under(Below, Under2, Under1)
    ),
    under(Segments, Under1, Under).

own_colour(Colours, Number, R, Roots, Place, Colour) :-
    (   Colours == leaf
    ->  Place is Number-1
    ;   once(nth0(Place, Roots, R))
    ),
    palette_colour(Place, Colour).

%   asked_looks(Asked, R, S, Faces, Place-Colour, Looks): sections of neighbours
%   are hatched two ways.

asked_looks(_, R, S, [1-section], Place-Colour, [Look]) :-
    !,
    face_look(R, S, section, Colour, Look0),
    (   selectchk(hatched, Look0, Look1)
    ->  Way is 1 - 2*(Place mod 2),
        Look = [hatched(Way)|Look1]
    ;   Look = Look0
    ).
asked_looks(nothing, _, _, _, _-Colour, [[colour(Colour)]]).
asked_looks(leaves, R, S, Faces, Place-Colour, Looks) :-
    (   look(_, face(_, _))
    ->  asked_looks(faces, R, S, Faces, Place-Colour, Looks)
    ;   face_look(R, S, any, Colour, Look),
        Looks = [Look]
    ).
asked_looks(faces, R, S, Faces, _-Colour, [Palette|Looks]) :-
    Palette = [colour(Colour)],
    findall(Look,
            ( face_names(1, Faces, Name), face_look(R, S, Name, Colour, Look) ),
            Looks).

%   face_names(F, Faces, Name): the names of the faces 1, 2, ...; `none` where
%   there is none of that number.

face_names(F, [N-Name0|Faces], Name) :-
    (   N =:= F
    ->  Rest = Faces,
        Own = Name0
    ;   Rest = [N-Name0|Faces],
        Own = none
    ),
    (   Name = Own
    ;   G is F+1,
        face_names(G, Rest, Name)
    ).

face_look(R, S, Face, Colour, Look) :-
    (   Face \== none,
        surface_look(R, S, Face, Look0),
        ground(Look0)
    ->  true
    ;   Look0 = []
    ),
    with_colour(Look0, Colour, Look).

with_colour(Look0, Colour, Look) :-
    (   memberchk(colour(_), Look0)
    ->  Look = Look0
    ;   Look = [colour(Colour)|Look0]
    ).

palette_colour(Place, Colour) :-
    palette(Palette),
    length(Palette, N),
    K is Place mod N,
    nth0(K, Palette, Colour).

palette([ rgb(118,160,208), rgb(222,158,78), rgb(126,176,116), rgb(200,96,92),
          rgb(160,130,190), rgb(222,202,96), rgb(96,176,176), rgb(200,140,170)
        ]).

%!  line_layers(+Scene, +Y, -Layers) is det.
%
%   Layers are layer(X1, X2, R, S, F, Part): on the line Y, in dots, between X1
%   and X2, in 1/256 dot, Part of the light comes from face F of leaf S of root
%   R, as far as looks let it through. Where all is opaque they are the spans of
%   line_spans/3, each with 1.0.
%
%   @error instantiation_error: Scene is not known
%   @error domain_error(scan_line, Y)

line_layers(Scene, Y, Layers) :-
    must_be(nonvar, Scene),
    scene_handle(Scene, Handle),
    scene_opacities(Scene, opaque(Opacities,Leaves)),
    owners_asked(Scene,
                 shading_layers(Handle, Y, Opacities, Leaves, Layers)).

%!  scene_opacities(+Scene, -Opaque) is det.
%
%   Opaque is opaque(Opacities, Leaves), as of shading_layers/5.

scene_opacities(Scene, opaque(Opacities,Leaves)) :-
    scene_looks(Scene, root, Looks, Leaves),
    maplist(look_opacity, Looks, Opacities).

%!  layer_shares(+Layers, +Opaque, -Shares) is det.
%
%   Shares are share(Z, R, Leaf, F, Nth, Part) of those of Layers
%   (seen_layers/4) that light comes from: the Nth layer of that face, from 0,
%   has that Part of it. Opaque is as of scene_opacities/2.

layer_shares(Layers, Opaque, Shares) :-
    layer_shares(Layers, Opaque, 1.0, [], Shares).

%   layer_shares(Layers, Opaque, Left, Before, Shares): as long as something is
%   Left, the layers Before being nearer.

layer_shares([], _, _, _, []).
layer_shares([layer(Z,R,Leaf,F)|Layers], Opaque, Left0, Before, Shares) :-
    face_opacity(Opaque, Leaf, F, A),
    Part is Left0*A,
    Left is Left0-Part,
    findall(F, member(Leaf-F, Before), Same),
    length(Same, Nth),
    (   Part > 0
    ->  Shares = [share(Z,R,Leaf,F,Nth,Part)|Shares1]
    ;   Shares = Shares1
    ),
    (   Left > 0
    ->  layer_shares(Layers, Opaque, Left, [Leaf-F|Before], Shares1)
    ;   Shares1 = []
    ).

%!  face_opacity(+Opaque, +Leaf, +F, -A) is det.
%
%   The face F of leaf number Leaf is A opaque, 0 to 1.

face_opacity(opaque(Opacities,Leaves), Leaf, F, A) :-
    nth1(Leaf, Leaves, Own),
    (   nth0(F, Own, Place)
    ->  true
    ;   Own = [Place|_]
    ),
    nth0(Place, Opacities, A).

%!  look_opacity(+Look, -Opacity) is det.

look_opacity(Look, A) :-
    (   memberchk(opacity(A0), Look)
    ->  A = A0
    ;   memberchk(shade(xray), Look)
    ->  A = 0.25
    ;   A = 1
    ).
