:- module(sg_explain_pixel,
          [ pixel_because/4,            % +X, +Y, +Options, -Because
            unseen_because/3            % +S, +Options, -Because
          ]).
:- use_module(explain_face,
              [ before_because/5, behind_because/6, leaf_names/6,
                look_because/6, owner_because/5, passed/3, place_because/5,
                reason_because/4,
                side_normal/7, tone_because/4, tree_because/4, walked/5 ]).
:- use_module(explain_pair, [decided_by/2]).
:- use_module(explain_tree, [tree_way/3, false_reason/4]).
:- use_module('../kernel', [image_dot/4, shading_layers/5, shading_place/5]).
:- use_module('../shading/group_owner', [owners_asked/2]).
:- use_module('../shading/seen', [met/4, seen_layers/4, slice/3]).
:- use_module('../shading/shaded_picture',
              [picture_image/3, shade_has_shadows/1, world_scene/2]).
:- use_module('../shading/shading_light', [light_layers/4]).
:- use_module('../shading/shading_scene',
              [ scene_handle/2, scene_leaf/2, scene_model/2, scene_place/2,
                scene_scale/2, scene_size/2 ]).
:- use_module('../shading/surface_look',
              [ face_opacity/4, layer_shares/3, scene_looks/4,
                scene_opacities/2 ]).
:- use_module('../shading/surface_tone', [light_ways/1]).
:- use_module('../store', [segment/3]).
:- use_module(library(apply), [maplist/3, maplist/4]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth0/3, nth1/3, sum_list/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).

/** <module> Explain: why a dot of a shaded picture has its colour (CB-7, CB-8).

The definition (seen.pl) runs again for the one line of sight: what it meets,
group by group, which leaf each group enters or leaves, and why the tree of the
root does not hold there yet. Then the decisions about looks say how the face is
shown. The bytes of a dot are those of the picture itself.

Options are those of shaded_picture/4 and picture_image/3 that the picture was
made with, or scene(Scene).
*/

%!  pixel_because(+X, +Y, +Options, -Because) is semidet.
%
%   Because says why the dot X of row Y, counted from 0 from the upper left, has
%   its colour. Fails if the picture has no such dot.

pixel_because(X, Y, Options, [because(pixel(X,Y,Bytes), Because)]) :-
    integer(X),
    integer(Y),
    picture_scene(Options, Scene),
    scene_size(Scene, Width-Height),
    X >= 0, X < Width,
    Y >= 0, Y < Height,
    picture_image(Scene, Options, Image),
    image_dot(Image, X, Y, Bytes),
    option(smooth(Lines), Options, 4),
    All is 256*Lines,
    scene_opacities(Scene, Opaque),
    dot_parts(Scene, X, Y, Lines, Opaque, Parts),
    option(colours(Colours), Options, root),
    scene_looks(Scene, Colours, Looks, Leaves),
    maplist(part_because(seen(Scene,X,Y,All,Options,Looks,Leaves)), Parts,
            Seen),
    background_because(Parts, All, Options, Rest),
    findall(because(Statement,[]), dot_statement(Options, Statement), Dot),
    append([Seen,Rest,Dot], Because).

%   dot_statement(Options, Statement): what is done with the sum.

dot_statement(Options, dot_by_rule(By)) :-
    \+ option(background(none), Options),
    decided_by(pixel_colour/4, By),
    By \== default.
dot_statement(Options, nearest_of_palette(Most)) :-
    option(palette(Most), Options).

picture_scene(Options, Scene) :-
    (   option(scene(Scene0), Options)
    ->  Scene = Scene0
    ;   world_scene(Options, Scene)
    ).

%   dot_parts(Scene, X, Y, Lines, Opaque, Parts): part(Share, R, Leaf, F, Z,
%   At), the largest first: of all lines face F has so many 1/256 dots, each
%   counted as much as its light comes from that face; At is X1-Y1, in the
%   middle of the widest piece, where it has the depth Z. Opaque is as of
%   scene_opacities/2.

dot_parts(Scene, X, Y, Lines, Opaque, Parts) :-
    Last is Lines-1,
    findall(seen(R,Leaf,F,Nth)-piece(Share,X1,Y1,Z),
            ( between(0, Last, K),
              Y1 is Y + (K+0.5)/Lines,
              dot_cell(Scene, X, Y1, Opaque, A, B),
              X1 is (A+B)/512.0,
              seen_layers(Scene, X1, Y1, Layers),
              layer_shares(Layers, Opaque, Shares),
              member(share(Z,R,Leaf,F,Nth,Part), Shares),
              Share is (B-A)*Part ),
            Pieces0),
    keysort(Pieces0, Pieces),
    group_pairs_by_key(Pieces, Groups),
    findall(Sum-part(Sum,R,Leaf,F,Z,X1-Y1),
            ( member(seen(R,Leaf,F,_)-Own, Groups),
              findall(S, member(piece(S,_,_,_), Own), Ss),
              sum_list(Ss, Sum),
              sort(1, @>=, Own, [piece(_,X1,Y1,Z)|_]) ),
            Parts0),
    sort(1, @>=, Parts0, Sorted),
    pairs_values(Sorted, Parts).

%   dot_cell(Scene, X, Y, Opaque, A, B): between A and B, in 1/256 dot, the same
%   is seen on the line Y through dot X.

dot_cell(Scene, X, Y, Opaque, A, B) :-
    scene_handle(Scene, Handle),
    Opaque = opaque(Opacities,Leaves),
    owners_asked(Scene,
                 shading_layers(Handle, Y, Opacities, Leaves, Layers)),
    Left is 256*X,
    Right is Left+256,
    findall(End,
            ( member(layer(X1,X2,_,_,_,_), Layers),
              member(End, [X1,X2]),
              End > Left,
              End < Right ),
            Ends),
    sort([Left,Right|Ends], Cuts),
    append(_, [A,B|_], Cuts).

background_because(Parts, All, Options, Because) :-
    findall(C, member(part(C,_,_,_,_,_), Parts), Cs),
    sum_list(Cs, Covered),
    (   Covered < All
    ->  Percent is 100.0*(All-Covered)/All,
        option(background(Colour), Options, white),
        Because = [because(background_part(Percent,Colour), [])]
    ;   Because = []
    ).

%   part_because(Seen, Part, Because)

part_because(seen(Scene,X,Y,All,Options,Looks,Leaves),
             part(Covered,R,Leaf,F,Z,X1-Y1),
             because(seen_part(Percent,What,Leaf,S,Name,R), Because)) :-
    Percent is 100.0*Covered/All,
    leaf_names(Scene, Leaf, F, What, S, Name),
    walked(Scene, X1, Y1, Z, Walk),
    place_because(Scene, X1, Y1, Walk, Place),
    tree_because(Scene, Leaf, Walk, Tree),
    owner_because(Scene, R, Leaf-F, Walk, Owner),
    before_because(Scene, X1, Y1, Walk, Before),
    nth1(Leaf, Leaves, Places),
    (   nth0(F, Places, LookPlace)
    ->  true
    ;   Places = [LookPlace|_]
    ),
    nth0(LookPlace, Looks, Look),
    behind_because(Scene, X1, Y1, Walk, Look, Behind),
    option(colours(Colours), Options, root),
    (   scene_leaf(Scene, leaf(Leaf,_,_,_,Faces)),
        memberchk(F-Face0, Faces)
    ->  Face = Face0
    ;   Face = any
    ),
    look_because(R, S, Face, Colours, Look, LookWhy),
    option(shade(Shade), Options, lambert),
    side_normal(Scene, X, Y, X1-Y1, part(R,Leaf,F), Walk, Normal),
    light_stops(Scene, X1-Y1, Z, Leaf, Normal, Look, Options, Stops),
    tone_because(Normal, [shade(Shade)|Look], Stops, ToneWhy),
    append([Place,Tree,Owner,Before,Behind,LookWhy,ToneWhy], Because).


%   light_stops(Scene, At, Z, Leaf, Normal, Look, Options, Stops): what is
%   between each light and the place, as of tone_because/4. The place is let
%   out along its normal, as shadow.c does; cuts have no shadows.

light_stops(Scene, X-Y, Z, Leaf, vector(A,B,C), Look, Options, Stops) :-
    option(shadows(true), Options),
    option(shade(Shade), Options, lambert),
    shade_has_shadows(Shade),
    decided_by(tone/3, default),
    \+ memberchk(hatched(_), Look),
    !,
    scene_handle(Scene, Handle),
    shading_place(Handle, X, Y, Z, point(X0,Y0,Z0)),
    scene_scale(Scene, Scale),
    leaf_out(Scene, Leaf, Out0),
    Out is Out0/Scale,
    maplist(let_out(Out), [X0,Y0,Z0], [A,B,C], Point),
    light_ways(Ways),
    scene_opacities(Scene, Opaque),
    maplist(way_stops(Scene, Opaque, Point, vector(A,B,C)), Ways, Stops).
light_stops(_, _, _, _, _, _, _, []).

let_out(Out, X0, A, X) :-
    X is X0 + Out*A.

%   leaf_out(Scene, Leaf, Out): facets are in front of what they stand for, or
%   behind it.

leaf_out(Scene, Leaf, Out) :-
    scene_model(Scene, model(_, Facts, _)),
    (   member(Fact, Facts),
        arg(1, Fact, Leaf),
        Fact = flat(_,_,[_|_],_)
    ->  Out = 0.5
    ;   Out is 1/32
    ).

way_stops(Scene, Opaque, Point, vector(A,B,C), Way, stops(Come,Because)) :-
    Way = [X,Y,Z],
    (   A*X + B*Y + C*Z > 0
    ->  light_layers(Scene, Way, Point, Layers),
        layer_shares(Layers, Opaque, Shares),
        findall(Part, member(share(_,_,_,_,_,Part), Shares), Parts),
        sum_list(Parts, Stopped),
        Come is 1.0-Stopped,
        findall(because(light_stopped(Percent,What,Leaf,S,Name,R), []),
                ( member(share(_,R,Leaf,F,_,Part), Shares),
                  Percent is 100.0*Part,
                  leaf_names(Scene, Leaf, F, What, S, Name) ),
                Because)
    ;   Come = 1.0,
        Because = []
    ).


                /*******************************
                *         WHAT IS NOT SEEN     *
                *******************************/

%!  unseen_because(+S, +Options, -Because) is semidet.
%
%   Because says why nothing of segment S, a root, a node or a leaf, is seen in
%   the picture; or where it is. Fails if there is no segment S.

unseen_because(S, Options, [because(Statement, Because)]) :-
    integer(S),
    segment(S, Kind, _),
    picture_scene(Options, Scene),
    findall(Place, place_of(Scene, S, Place), Places),
    scene_opacities(Scene, Opaque),
    (   Places == []
    ->  Statement = not_in_picture(S, Kind),
        Because = []
    ;   seen_dots(Scene, Opaque, Places, Dots, X, Y),
        Dots > 0
    ->  Statement = seen_after_all(S, Dots, X, Y),
        Because = []
    ;   Statement = unseen(S),
        sampled_places(Scene, Places, Samples),
        findall(Reason-at(X1,Y1),
                ( member(sample(Place,X1,Y1), Samples),
                  unseen_at(Scene, Opaque, Place, X1, Y1, Reason) ),
                Reasons),
        unseen_reasons(Reasons, Because)
    ).

%   place_of(Scene, S, Place): a leaf of the kernel that is one of S.

place_of(Scene, S, Place) :-
    scene_place(Scene, place(Place,R,Leaf)),
    (   R =:= S
    ->  true
    ;   once(scene_leaf(Scene, leaf(Leaf,_,S,_,_)))
    ->  true
    ;   tree_way(Scene, Place, Way),
        member(Step, Way),
        ( Step = placed(S) ; Step = operand(_,_,_,S) )
    ->  true
    ).

%   seen_dots(Scene, Opaque, Places, Dots, X, Y): about how many dots show them,
%   and one of these.

seen_dots(Scene, Opaque, Places, Dots, X, Y) :-
    scene_handle(Scene, Handle),
    findall(Leaf,
            ( member(Place, Places), scene_place(Scene, place(Place,_,Leaf)) ),
            Leaves0),
    sort(Leaves0, Leaves),
    scene_size(Scene, _-Height),
    Last is Height-1,
    Opaque = opaque(Opacities,Every),
    findall(Wide-at(X1,Row),
            ( between(0, Last, Row),
              Middle is Row+0.5,
              owners_asked(Scene,
                           shading_layers(Handle, Middle, Opacities, Every,
                                          Layers)),
              member(layer(A,B,_,Leaf,_,_), Layers),
              memberchk(Leaf, Leaves),
              Wide is B-A,
              X1 is (A+B)//512 ),
            Wides),
    (   sort(1, @>=, Wides, [_-at(X,Y)|_])
    ->  findall(W, member(W-_, Wides), Ws),
        sum_list(Ws, Sum),
        Dots is max(1, round(Sum/256))
    ;   Dots = 0
    ).

%   sampled_places(Scene, Places, Samples): in the middle of their slices, on 64
%   lines at most.

sampled_places(Scene, Places, Samples) :-
    scene_size(Scene, Width-Height),
    member(Step0, [64,4096]),
    Step is max(1, Height//Step0),
    Last is (Height-1)//Step,
    findall(sample(Place,X,Y),
            ( between(0, Last, I),
              Y is I*Step + 0.5,
              place_slice(Scene, Places, Y, Place, X1, X2),
              Left is max(0.0, X1),
              Right is min(float(Width), X2),
              Left < Right,
              X is (Left+Right)/2 ),
            Samples0),
    Samples0 = [_|_],
    !,
    Samples = Samples0.
sampled_places(_, _, []).

place_slice(Scene, Places, Y, Place, X1, X2) :-
    slice(Scene, Y, slice(_,Leaf,_,Sense,X1,X2,_)),
    Sense =\= 0,
    scene_place(Scene, place(Place,_,Leaf)),
    memberchk(Place, Places).

%   unseen_at(Scene, Opaque, Place, X, Y, Reason): of each of its faces there.

unseen_at(Scene, Opaque, Place, X, Y, Reason) :-
    met(Scene, X, Y, Groups),
    passed(Groups, [], All),
    append(Before, [passed(group(Z,Mets),In)|_], All),
    memberchk(met(Place,_,_), Mets),
    scene_place(Scene, place(Place,R,_)),
    (   append(_, [passed(_,In0)], Before)
    ->  true
    ;   In0 = []
    ),
    false_reason(Scene, R, In, Now),
    false_reason(Scene, R, In0, Was),
    (   Now == true,
        Was == true
    ->  Reason = buried(R)
    ;   Now == true
    ->  seen_instead(Scene, Opaque, X, Y, Z, R, Reason)
    ;   Was \== true
    ->  reason_because(Scene, R, Now, [because(Why, _)]),
        Reason = not_there(Why)
    ;   Reason = back(R)
    ).

%   seen_instead(Scene, Opaque, X, Y, Z, R, Reason): what is seen before the
%   root R, which begins in the depth Z, or in it.

seen_instead(Scene, Opaque, X, Y, Z, R0, hidden(R,Leaf,S,Name)) :-
    seen_layers(Scene, X, Y, Layers),
    append(Before, [layer(Z,R0,_,_)|_], Layers),
    member(layer(_,R,Leaf,F), Before),
    face_opacity(Opaque, Leaf, F, A),
    A >= 1,
    !,
    leaf_names(Scene, Leaf, 0, _, S, Name).
seen_instead(Scene, _, X, Y, Z, R, owned(What,Leaf,S,Name,R)) :-
    seen_layers(Scene, X, Y, Layers),
    memberchk(layer(Z,R,Leaf,F), Layers),
    !,
    leaf_names(Scene, Leaf, F, What, S, Name).
seen_instead(_, _, _, _, _, _, thin).

%   unseen_reasons(Reasons, Because): each with how often it was met and where,
%   the most frequent first; backs only if there is nothing else.

unseen_reasons([], [because(out_of_the_picture, [])]) :-
    !.
unseen_reasons(Reasons0, Because) :-
    (   member(Reason-_, Reasons0),
        Reason \= back(_)
    ->  findall(Reason1-At,
                ( member(Reason1-At, Reasons0), Reason1 \= back(_) ), Reasons1)
    ;   Reasons1 = Reasons0
    ),
    keysort(Reasons1, Reasons),
    group_pairs_by_key(Reasons, Groups),
    findall(Count-because(unseen_where(Count,X,Y), [because(Why, [])]),
            ( member(Reason2-Ats, Groups),
              length(Ats, Count),
              Ats = [at(X0,Y0)|_],
              X is floor(X0),
              Y is floor(Y0),
              unseen_why(Reason2, Why) ),
            Counted0),
    sort(1, @>=, Counted0, Counted),
    pairs_values(Counted, Because).

unseen_why(hidden(R,Leaf,S,Name), hidden_by_leaf(Leaf,S,Name,R)).
unseen_why(buried(R), buried_in(R)).
unseen_why(back(R), back_side(R)).
unseen_why(owned(What,Leaf,S,Name,R), owned_by_face(What,Leaf,S,Name,R,By)) :-
    decided_by(owner/3, By).
unseen_why(thin, thinner_than_a_dot).
unseen_why(not_there(Why), Why).
