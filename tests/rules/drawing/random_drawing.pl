:- encoding(utf8).
:- module(random_drawing,
          [ case/3,
            expected/4,
            random_drawing/4,
            seeds/1,
            written/5
          ]).
:- use_module(library(random)).
:- use_module(rules(drawing/drawing)).
:- use_module(rules(drawing/dxf_colour)).
:- use_module(rules(drawing/style)).
:- use_module(rules(drawing/ink)).
:- use_module(rules(sheet/lettering)).
:- use_module(rules(store)).
:- use_module(default_look).
/* Random drawings with random styles, for tests; what is to be read of them. */

% A style of any look for each visibility, role and segment that is drawn.
% look(Width, Screen, Print, Runs, Pen, Layer), and its row of a style file.
random_look(look(Width,Screen,Print,Runs,Pen,Layer),
            [width(Mm),Colour,dashes(Dashes),pen(Pen),layer(Layer)]) :-
    random_member(Width, [100,180,250,500,700,1000,2130]),
    Mm is Width/1000,
    random_colour(C1, Screen),
    (   maybe
    ->  random_colour(C2, Print),
        Colour = colour(C1, C2)
    ;   Print = Screen,
        Colour = colour(C1)
    ),
    random_dashes(Width, Dashes, Runs),
    random_between(1, 6, Pen),
    random_member(Layer, ['A','B1','MY_LAYER-2','$X','0']).

random_colour(Colour, RGB) :-
    (   maybe(0.6)
    ->  findall(C-R, colour(C, R), Colours),
        random_member(Colour-RGB, Colours)
    ;   random_between(0, 255, R),
        random_between(0, 255, G),
        random_between(0, 255, B),
        RGB = rgb(R,G,B),
        Colour = RGB
    ).

random_dashes(Width, Dashes, Runs) :-
    random_between(1, 4, Kind),
    random_dashes(Kind, Width, Dashes, Runs).

random_dashes(1, _, solid, []).
random_dashes(2, _, hidden, [3000,900]).
random_dashes(3, Width, Dashes, Runs) :-
    findall(T-R, type(T, R), Types),
    random_member(Dashes-Own, Types),
    findall(Run, ( member(R, Own), Run is max(1, round(R*Width)) ), Runs).
random_dashes(4, _, Dashes, Runs) :-
    random_member(Dashes-Runs, [ [5,1.25]-[5000,1250],
                                 [5.0,1.2,0.5,1.2]-[5000,1200,500,1200] ]).

random_drawing(Seed, drawing(sheet(W,H,2.5),Views), Rows, Looks) :-
    set_random(seed(Seed)),
    random_between(20 000, 300 000, W),
    random_between(20 000, 200 000, H),
    random_member(Names, [[''],[front,top]]),
    maplist(random_view(W-H), Names, Views),
    findall(V-R-S,
            ( member(view(_,Strokes,Texts), Views),
              (   member(stroke(V,R,S,_,_,_,_), Strokes)
              ;   member(text(_,_,_,_,_), Texts),
                  V = visible, R = text, S = 0
              )
            ),
            Keys0),
    sort(Keys0, Keys),
    findall(Key-Look/Row,
            ( member(Key, Keys),
              random_look(Look, Properties),
              Key = V-R-S,
              Row = line(V,R,S,Properties)
            ),
            All),
    findall(Key-Look, member(Key-Look/_, All), Looks),
    findall(Row, member(_-_/Row, All), Rows).

random_view(Size, Name, view(Name,Strokes,Texts)) :-
    random_between(0, 9, N),
    findall(Key-Stroke,
            ( between(1, N, _),
              random_stroke(Size, Stroke),
              Stroke = stroke(V,R,_,_,_,_,_),
              Key = V-R
            ),
            Keyed0),
    keysort(Keyed0, Keyed),             % a group for each
    findall(Stroke, member(_-Stroke, Keyed), Strokes),
    random_between(0, 2, M),
    findall(text(X,Y,Height,Anchor,String),
            ( between(1, M, _),
              random_point(Size, X-Y),
              random_between(1800, 7000, Height),
              random_member(Anchor, [start,middle,end]),
              random_member(String, ["A <b> & 'c'", "상관 50%", "x"])
            ),
            Texts).

random_point(W-H, X-Y) :-
    random_between(0, W, X),
    random_between(0, H, Y).

random_stroke(Size, stroke(V,R,S,Edges,Points,Start,End)) :-
    (   maybe(0.8)
    ->  random_member(V, [visible,hidden]),
        random_member(R, [penetration,outline,crease,border,curve,section,
                          smooth,mesh]),
        random_between(1, 3, S)
    ;   V = visible,
        random_member(R, [frame,field,hatching,cutting,cutting_end,arrow,
                          symbol,axis,centre_line]),
        S = 0
    ),
    random_between(2, 6, N),
    random_points(N, Size, Points0),
    (   N > 2,
        maybe(0.3)
    ->  Points0 = [First|_],
        append(Points0, [First], Points),
        Start = ring,
        End = ring
    ;   Points = Points0,
        random_member(Start, [joint,cut]),
        random_member(End, [joint,cut])
    ),
    (   S =:= 0
    ->  Edges = []
    ;   length(Points, Count),
        Pieces is Count-1,
        length(Edges, Pieces),
        maplist([E]>>random_between(1, 40, E), Edges)
    ).

% Far enough apart to be different in every format.
random_points(N, Size, Points) :-
    repeat,
    length(Points, N),
    maplist(random_point(Size), Points),
    forall(( nth1(I, Points, X0-Y0), nth1(J, Points, X1-Y1), I < J ),
           abs(X0-X1)+abs(Y0-Y1) > 100),
    !.

written(Format, Drawing, Rows, Options, Text) :-
    with_output_to(string(Text),
                   ( current_output(Out),
                     write_drawing_stream(Format, Out,
                                          [ drawing(Drawing), style(Rows)
                                          | Options ]) )).

% Every line in painting order, view by view: line(V,R,S,Edges,Points,Look,
% Stroke); letters after the lines of a view.
expected(Texts, drawing(_,Views), Looks, Lines) :-
    findall(Line, expected_line(Texts, Views, Looks, Line), Lines).

expected_line(Texts, Views, Looks, line(View,V,R,S,Edges,Points,Look,
                                        Stroke)) :-
    member(view(View,Strokes,Written), Views),
    (   member(Stroke, Strokes),
        Stroke = stroke(V,R,S,Edges,Points,_,_),
        memberchk(V-R-S-Look, Looks)
    ;   Texts == drawn,
        member(Text, Written),
        Text = text(_,_,Height,_,_),
        memberchk(visible-text-0-Look0, Looks),
        Look0 = look(Width0,Screen,Print,Runs,Pen,Layer),
        Width is min(Width0, round(Height/10)),
        Look = look(Width,Screen,Print,Runs,Pen,Layer),
        lettering(Text, Letters),
        member(Points, Letters),
        V-R-S-Edges = visible-text-0-[],
        Stroke = stroke(V,R,S,[],Points,joint,joint)
    ).

seeds(Seed) :-
    between(1, 30, Seed).

% Prints the seed of a drawing that is wrong.
:- meta_predicate case(+, +, 0).

case(Format, Seed, Goal) :-
    (   catch(Goal, wrong(What), true)
    ->  true
    ;   What = differs
    ),
    (   var(What)
    ->  true
    ;   format(user_error, '~w, seed ~w: ~q~n', [Format,Seed,What]),
        fail
    ).
