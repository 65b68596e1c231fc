:- module(sg_explain_face,
          [ leaf_names/6,               % +Scene, +Leaf, +F, -What, -S, -Name
            walked/5,                   % +Scene, +X, +Y, +Z, -Walk
            passed/3,                   % +Groups, +In, -Passed
            place_because/5,            % +Scene, +X, +Y, +Walk, -Because
            tree_because/4,             % +Scene, +Leaf, +Walk, -Because
            owner_because/5,            % +Scene, +R, +Face, +Walk, -Because
            before_because/5,           % +Scene, +X, +Y, +Walk, -Because
            behind_because/6,           % +Scene, +X, +Y, +Walk, +Look, -Because
            reason_because/4,           % +Scene, +R, +Reason, -Because
            look_because/6,             % +R, +S, +Face, +Colours, +Look,
                                        % -Because
            side_normal/7,              % +Scene, +X, +Y, +At, +Part, +Walk,
                                        % -Normal
            tone_because/4              % +Normal, +Look, +Stops, -Because
          ]).
:- use_module(explain_pair, [decided_by/2]).
:- use_module(explain_tree, [tree_way/3, false_reason/4, takes_away/1]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../kernel', [light_srgb/2, shading_place/5, shading_point/6]).
:- use_module('../shading/group_owner', [group_owner/5, owners_asked/2]).
:- use_module('../shading/seen', [met/4, root_faces/6]).
:- use_module('../shading/shading_scene',
              [ named_face/3, scene_handle/2, scene_leaf/2, scene_place/2,
                scene_root/2, seen_through/2 ]).
:- use_module('../shading/surface_look', [look_opacity/2, look_source/5]).
:- use_module('../shading/surface_ramp', [ramp/3]).
:- use_module('../shading/surface_tone',
              [look_shine/2, picture_normal/2, tone/3, tone_sum/3]).
:- use_module('../store', [segment/3]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth1/3, sum_list/2]).
:- use_module(library(ordsets), [ord_symdiff/3]).

/** <module> Explain: what is said of a face in a dot (explain_pixel.pl).

Each part is a list of because(Statement, Because), which explain_pixel_en.pl
and explain_pixel_ko.pl put into words.
*/

%!  leaf_names(+Scene, +Leaf, +F, -What, -S, -Name) is det.
%
%   What the face F is of leaf number Leaf, which is a Name, of segment S, or 0.

leaf_names(Scene, Leaf, F, What, S, Name) :-
    once(scene_leaf(Scene, leaf(Leaf,_,S,Term,Faces))),
    named_face(F, Faces, What),
    (   Term == rows,
        S > 0
    ->  segment(S, _, Of)
    ;   Of = Term
    ),
    bare_name(Of, Name).

bare_name(at(_,Term), Name) :-
    !,
    bare_name(Term, Name).
bare_name(named(_,Term), Name) :-
    !,
    bare_name(Term, Name).
bare_name(Term, Name) :-
    (   compound(Term)
    ->  functor(Term, Name, _)
    ;   Name = Term
    ).


                /*******************************
                *         LINE OF SIGHT        *
                *******************************/

%!  walked(+Scene, +X, +Y, +Z, -Walk) is semidet.
%
%   Walk is walk(Before, Group, In, Behind): the groups that the line of sight
%   through (X, Y) meets before the one at the depth Z, each passed(Group, In)
%   with the places of the leaves that it is in after it; that Group; and
%   groups behind it, likewise.

walked(Scene, X, Y, Z, walk(Before,Group,In,Behind)) :-
    Group = group(Z, _),
    met(Scene, X, Y, Groups),
    passed(Groups, [], All),
    append(Before, [passed(Group,In)|Behind], All),
    !.

%!  passed(+Groups, +In, -Passed) is det.
%
%   Passed has passed(Group, In) for each of Groups, from In on.

passed([], _, []).
passed([Group|Groups], In0, [passed(Group,In)|Passed]) :-
    Group = group(_, Mets),
    foldl(toggled, Mets, In0, In),
    passed(Groups, In, Passed).

toggled(met(Place,_,_), In0, In) :-
    ord_symdiff(In0, [Place], In).

%!  place_because(+Scene, +X, +Y, +Walk, -Because) is det.
%
%   Where the place is in the model.

place_because(Scene, X, Y, walk(_,group(Z,_),_,_),
              [because(seen_place(Point), [])]) :-
    model_place(Scene, X, Y, Z, Point).

model_place(Scene, X, Y, Z, Point) :-
    scene_handle(Scene, Handle),
    shading_place(Handle, X, Y, Z, Point).

%!  tree_because(+Scene, +Leaf, +Walk, -Because) is det.
%
%   The way from the leaf up to the root.

tree_because(Scene, Leaf, walk(_,group(_,Mets),_,_), Because) :-
    met_of(Scene, Leaf, Mets, met(Place,_,Sense)),
    (   tree_way(Scene, Place, Way0)
    ->  Way = Way0
    ;   Way = []                        % a section
    ),
    maplist(step_because, Way, Steps),
    (   Sense < 0
    ->  append(Steps, [because(inner_side, [])], Because)
    ;   Because = Steps
    ).

met_of(Scene, Leaf, Mets, Met) :-
    Met = met(Place,_,_),
    member(Met, Mets),
    scene_place(Scene, place(Place,_,Leaf)),
    !.

step_because(placed(N), because(placed_as(N), [])).
step_because(operand(I,Count,Operation,N),
             because(operand_of(I,Count,Operation,N,Away), [])) :-
    (   takes_away(operand(I,Count,Operation,N))
    ->  Away = taken_away
    ;   Away = kept
    ).

%!  owner_because(+Scene, +R, +Face, +Walk, -Because) is det.
%
%   Why of the faces of root R that lie in one another there Face = Leaf-F is
%   seen.

owner_because(Scene, R, Face, walk(Before,group(_,Mets),In,_), Because) :-
    (   append(_, [passed(_,In0)], Before)
    ->  true
    ;   In0 = []
    ),
    once(( scene_root(Scene, Root), Root = root(R,_) )),
    root_faces(Scene, Root, Mets, In0, In, Faces),
    findall(because(not_owner(What,Leaf,S,Name), []),
            ( member(Leaf-F, Faces),
              Leaf-F \== Face,
              leaf_names(Scene, Leaf, F, What, S, Name) ),
            Others),
    (   Others == []
    ->  Because = []
    ;   decided_by(owner/3, By),
        Because = [because(owner(By), Others)]
    ).

%!  before_because(+Scene, +X, +Y, +Walk, -Because) is det.
%
%   What the line of sight passes before.

before_because(Scene, X, Y, walk(Before,group(Z,_),_,_), Because) :-
    model_place(Scene, X, Y, Z, Point),
    findall(because(Statement, Why),
            ( member(passed(group(Z1,Mets),In), Before),
              model_place(Scene, X, Y, Z1, Point1),
              apart(Point, Point1, Before1),
              passed_met(Scene, Mets, In, Before1, Statement, Why) ),
            Because).

passed_met(Scene, Mets, In, Apart, Statement, Why) :-
    append(_, [met(Place,F,Sense)|Rest], Mets),
    scene_place(Scene, place(Place,R,Leaf)),
    leaf_names(Scene, Leaf, F, What, S, Name),
    (   Sense > 0
    ->  Way = enters
    ;   Way = leaves
    ),
    Statement = passed(Way,What,Leaf,S,Name,Apart),
    (   \+ ( member(met(Other,_,_), Rest),
             scene_place(Scene, place(Other,R,_)) )
    ->  false_reason(Scene, R, In, Reason),     % said once of a root
        reason_because(Scene, R, Reason, Why)
    ;   Why = []
    ).

%!  reason_because(+Scene, +R, +Reason, -Because) is det.
%
%   Because says the Reason of false_reason/4 why the root R is not there.

reason_because(Scene, R, true, [because(Statement, [])]) :-
    !,
    findall(R1, scene_root(Scene, root(R1,_)), Roots),
    seen_through(Roots, Pairs),
    (   memberchk(R-_, Pairs)
    ->  decided_by(may_hide/2, By),
        Statement = let_through(R, By)
    ;   Statement = lets_through(R)
    ).
reason_because(_, R, cut, [because(cut_away(R), [])]) :-
    !.
reason_because(_, R, outside_all(N,Operation,Count),
               [because(outside_all(Operation,N,Count,R), [])]) :-
    !.
reason_because(_, R, taken_away(N,J,Operation),
               [because(taken_away(J,Operation,N,R), [])]) :-
    !.
reason_because(Scene, R, outside(Place),
               [because(outside_leaf(Leaf,S,Name,R), [])]) :-
    scene_place(Scene, place(Place,_,Leaf)),
    leaf_names(Scene, Leaf, 0, _, S, Name).

apart(point(X1,Y1,Z1), point(X2,Y2,Z2), Apart) :-
    Apart is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

%!  behind_because(+Scene, +X, +Y, +Walk, +Look, -Because) is det.
%
%   Faces behind it at which a solid begins again, or that it is see-through.

behind_because(_, _, _, _, Look, [because(see_through(A), [])]) :-
    look_opacity(Look, A),
    A < 1,
    !.
behind_because(Scene, X, Y, walk(_,group(Z,_),In,Behind), _, Because) :-
    model_place(Scene, X, Y, Z, Point),
    begun(Behind, Scene, In, Begun),
    findall(because(hidden_face(What,Leaf,S,Name,R,Apart), []),
            ( member(begun(R,Z1,Leaf,F), Begun),
              leaf_names(Scene, Leaf, F, What, S, Name),
              model_place(Scene, X, Y, Z1, Point1),
              apart(Point, Point1, Apart) ),
            Because).

begun([], _, _, []).
begun([passed(group(Z,Mets),In)|Behind], Scene, In0, Begun) :-
    findall(begun(R,Z,Leaf,F),
            ( scene_root(Scene, Root),
              Root = root(R,_),
              false_reason(Scene, R, In, true),
              \+ false_reason(Scene, R, In0, true),
              root_faces(Scene, Root, Mets, In0, In, Faces),
              group_owner(Scene, R, Faces, Leaf, F) ),
            New),
    append(New, Begun1, Begun),
    begun(Behind, Scene, In, Begun1).


                /*******************************
                *     LOOKS, TONES, COLOURS    *
                *******************************/

%!  look_because(+R, +S, +Face, +Colours, +Look, -Because) is det.
%
%   Where the colour of Look, that of a Face, comes from.

look_because(R, S, Face, Colours, Look, Because) :-
    memberchk(colour(Colour), Look),
    decided_by(surface_look/4, By),
    (   By \== default
    ->  Because = [because(look_by_rule(Colour,By), [])]
    ;   look_source(R, S, Face, colour(_), Segment)
    ->  Because = [because(look_of(Segment,Colour), [])]
    ;   Because = [because(look_of_palette(Colour,Colours), [])]
    ).

%!  side_normal(+Scene, +X, +Y, +At, +Part, +Walk, -Normal) is det.
%
%   Normal, or `unknown`, is that of the side in the model. That of a bent face
%   is taken in the middle of the dot, where it is seen there; behind others it
%   follows from the depth near At.

side_normal(Scene, X, Y, X1-Y1, part(R,Leaf,F), Walk, Normal) :-
    scene_handle(Scene, Handle),
    XM is X+0.5,
    YM is Y+0.5,
    (   owners_asked(Scene, shading_point(Handle, XM, YM, Span, _, Normal0)),
        Span = span(_,_,R,Leaf,F)
    ->  Normal = Normal0
    ;   owners_asked(Scene, shading_point(Handle, X1, Y1, Span, _, Normal0)),
        Span = span(_,_,R,Leaf,F)
    ->  Normal = Normal0
    ;   Walk = walk(_,group(Z,Mets),_,_),
        member(Met, Mets),
        Met = met(Place,F,_),
        scene_place(Scene, place(Place,R,Leaf)),
        near_place(Scene, X1, Y1, Met, right, Right),
        near_place(Scene, X1, Y1, Met, down, Down)
    ->  model_place(Scene, X1, Y1, Z, Here),
        Behind is Z+1.0,
        model_place(Scene, X1, Y1, Behind, Far),
        maplist(way_from(Here), [Right,Down,Far], [A,B,C]),
        cross(A, B, N),
        unit_against(C, N, Normal)
    ;   Normal = unknown
    ).

%   near_place(Scene, X, Y, Met, Way, Point): Point of the same slice a little
%   to the right, or down; if it ends there, on the other side.

near_place(Scene, X, Y, Met, Way, Step-Point) :-
    member(Step, [0.01,-0.01]),
    (   Way == right
    ->  X1 is X+Step,
        Y1 = Y
    ;   X1 = X,
        Y1 is Y+Step
    ),
    catch(met(Scene, X1, Y1, Groups), error(domain_error(_,_),_), fail),
    member(group(Z,Mets), Groups),
    memberchk(Met, Mets),
    model_place(Scene, X1, Y1, Z, Point),
    !.

way_from(point(X0,Y0,Z0), Step-point(X1,Y1,Z1), vector(X,Y,Z)) :-
    !,
    X is (X1-X0)/Step,
    Y is (Y1-Y0)/Step,
    Z is (Z1-Z0)/Step.
way_from(Here, Point, Way) :-
    way_from(Here, 1.0-Point, Way).

cross(vector(A,B,C), vector(D,E,F), vector(X,Y,Z)) :-
    X is B*F-C*E,
    Y is C*D-A*F,
    Z is A*E-B*D.

%   unit_against(Way, Vector, Unit)

unit_against(vector(A,B,C), vector(X0,Y0,Z0), vector(X,Y,Z)) :-
    Length is sqrt(X0*X0 + Y0*Y0 + Z0*Z0),
    (   A*X0 + B*Y0 + C*Z0 > 0
    ->  Factor is -1/Length
    ;   Factor is 1/Length
    ),
    X is Factor*X0,
    Y is Factor*Y0,
    Z is Factor*Z0.

%!  tone_because(+Normal, +Look, +Stops, -Because) is det.
%
%   How light it is, and which colour that has. Stops has for each light in turn
%   stops(Come, Because): Come, 0 to 1, of it comes there, and why; [] if there
%   are no shadows.

tone_because(unknown, _, _, []).
tone_because(Normal, Look, Stops, Because) :-
    Normal = vector(_, _, _),
    Because = [because(normal(Right,Up,Towards), []),
               because(tone(Tone,ToneBy), Shares),
               because(ramp(Shade,RampBy,RGB), [])|More],
    picture_normal(Normal, Seen),
    Seen = vector(Right0,Up0,Towards0),
    maplist(rounded, [Right0,Up0,Towards0], [Right,Up,Towards]),
    Look = [shade(Shade)|_],
    decided_by(tone/3, ToneBy),
    (   ToneBy == default
    ->  tone_sum(Shade, Constant, Ways),
        findall(because(Share, Why),
                ( Constant > 0,
                  Share = light_from_everywhere(Constant),
                  Why = []
                ; nth1(I, Ways, Way),
                  light_stops(Stops, I, Come, Why),
                  light_share(Way, Seen, Come, Share) ),
                Shares)
    ;   Shares = []
    ),
    (   Stops == []
    ->  tone_of(Look, Seen, Tone)
    ;   aggregate_all(sum(S), ( member(because(Share,_), Shares),
                                functor(Share, _, N), arg(N, Share, S) ),
                      Tone0),
        Tone is max(0.0, min(1.0, Tone0))
    ),
    decided_by(ramp/3, RampBy),
    ramp_bytes(Look, Tone, RGB),
    findall(because(Statement, []),
            more_light(Look, Normal, Stops, Statement), More).

light_stops(Stops, I, Come, Why) :-
    (   nth1(I, Stops, stops(Come0,Why0))
    ->  Come = Come0,
        Why = Why0
    ;   Come = 1.0,
        Why = []
    ).

%   more_light(Look, Normal, Stops, Statement): what is added to the light of
%   the tone.

more_light(Look, vector(X,Y,Z), Stops, shine(F,N,Added)) :-
    memberchk(shine(F,N), Look),
    look_shine(Look, shine(Power,Ways)),
    Ways = [_|_],
    findall(Light,
            ( nth1(I, Ways, way(A,B,C,Factor,_)),
              light_stops(Stops, I, Come, _),
              Light is Come*Factor*max(0.0, A*X+B*Y+C*Z)**Power ),
            Lights),
    sum_list(Lights, Added).
more_light(Look, _, _, hatched) :-
    memberchk(hatched(_), Look).

rounded(X0, X) :-
    X is round(X0*1.0e9)/1.0e9 + 0.0.

tone_of(Look, Seen, Tone) :-
    (   tone(Look, Seen, Tone0),
        number(Tone0)
    ->  Tone is max(0.0, min(1.0, Tone0))
    ;   Tone = 0.0
    ).

light_share(way(A,B,C,Factor,Least), vector(X,Y,Z), Come,
            light_from(A,B,C,Factor,Share)) :-
    Share is max(Least, Come*Factor*(A*X + B*Y + C*Z)).

ramp_bytes(Look, Tone, RGB) :-
    (   ramp(Look, Tone, Colour),
        shown_bytes(Colour, RGB0)
    ->  RGB = RGB0
    ;   RGB = [0,0,0]
    ).

shown_bytes(light(R,G,B), Bytes) :-
    !,
    maplist(light_srgb, [R,G,B], Bytes).
shown_bytes(Colour, [R,G,B]) :-
    colour_rgb(Colour, rgb(R,G,B)).
