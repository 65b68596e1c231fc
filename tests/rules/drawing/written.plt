:- encoding(utf8).
:- module(test_written, []).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(random)).
:- use_module(rules(drawing/drawing)).
:- use_module(rules(drawing/dxf_colour)).
:- use_module(rules(drawing/style)).
:- use_module(rules(drawing/ink)).
:- use_module(rules(sheet/lettering)).
:- use_module(rules(store)).
:- use_module(tests('rules/drawing/drawing_reader')).

/* Random drawings, written in every format, read by readers of our own
   (drawing_reader.pl): what is read is what was drawn, and every file is what
   its format says. */

% --- tables, stated a second time -------------------------------------------

colour(black,   rgb(0,0,0)).
colour(white,   rgb(255,255,255)).
colour(grey,    rgb(128,128,128)).
colour(red,     rgb(170,0,0)).
colour(green,   rgb(0,110,40)).
colour(blue,    rgb(0,60,170)).
colour(cyan,    rgb(0,130,150)).
colour(magenta, rgb(150,0,120)).
colour(yellow,  rgb(250,210,0)).
colour(orange,  rgb(220,110,0)).
colour(brown,   rgb(110,60,20)).

% ISO 128-2, table 1, in widths of the line: a long dash 24, a dash 12, a
% short one 6, a dot half a width, a gap 3, a long one 18.
type(dashed,        [12,3]).
type(dashed_spaced, [12,18]).
type(chain,         [24,3,0.5,3]).
type(chain_double,  [24,3,0.5,3,0.5,3]).
type(chain_triple,  [24,3,0.5,3,0.5,3,0.5,3]).
type(dotted,        [0.5,3]).
type(chain_dashed,  [24,3,6,3]).
type(dashed_dotted, [12,3,0.5,3]).

% Visibility, role: width, colour on the screen and on paper, runs, pen, layer.
default_look(visible, penetration, 700, rgb(170,0,0), rgb(0,0,0), [], 3,
             'VISIBLE_PENETRATION').
default_look(hidden, penetration, 350, rgb(170,0,0), rgb(0,0,0), [3000,900],
             2, 'HIDDEN_PENETRATION').
default_look(visible, outline, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_OUTLINE').
default_look(hidden, outline, 250, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_OUTLINE').
default_look(visible, crease, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_CREASE').
default_look(visible, border, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_BORDER').
default_look(visible, curve, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_CURVE').
default_look(hidden, curve, 250, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_CURVE').
default_look(visible, section, 500, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_SECTION').
default_look(visible, smooth, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_SMOOTH').
default_look(hidden, smooth, 180, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_SMOOTH').
default_look(visible, mesh, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'VISIBLE_MESH').
default_look(hidden, mesh, 180, rgb(0,0,0), rgb(0,0,0), [3000,900], 2,
             'HIDDEN_MESH').
default_look(visible, frame, 700, rgb(0,0,0), rgb(0,0,0), [], 1, 'FRAME').
default_look(visible, field, 250, rgb(0,0,0), rgb(0,0,0), [], 1, 'FIELD').
default_look(visible, hatching, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'HATCHING').
default_look(visible, cutting, 250, rgb(0,0,0), rgb(0,0,0), [], 1,
             'CUTTING').
default_look(visible, cutting_end, 700, rgb(0,0,0), rgb(0,0,0), [], 1,
             'CUTTING_END').
default_look(visible, arrow, 500, rgb(0,0,0), rgb(0,0,0), [], 1, 'ARROW').
default_look(visible, symbol, 350, rgb(0,0,0), rgb(0,0,0), [], 1, 'SYMBOL').
default_look(visible, axis, 250, rgb(0,0,0), rgb(0,0,0), [], 1, 'AXIS').
default_look(visible, text, 700, rgb(0,0,0), rgb(0,0,0), [], 1, 'TEXT').
% Of patterns.
default_look(visible, cut, 350, rgb(0,0,0), rgb(0,0,0), [], 1, 'CUT').
default_look(visible, fold_down, 250, rgb(0,60,170), rgb(0,0,0), [3000,1200],
             2, 'FOLD_DOWN').
default_look(visible, fold_up, 250, rgb(0,110,40), rgb(0,0,0),
             [5000,1200,500,1200], 3, 'FOLD_UP').
default_look(visible, penetration_line, 180, rgb(170,0,0), rgb(170,0,0), [],
             4, 'PENETRATION_LINE').
default_look(visible, mark, 180, rgb(0,0,0), rgb(0,0,0), [], 5, 'MARK').
default_look(visible, generator, 180, rgb(128,128,128), rgb(128,128,128), [],
             5, 'GENERATOR').
default_look(visible, generator_number, 180, rgb(128,128,128),
             rgb(128,128,128), [], 6, 'GENERATOR_NUMBER').
default_look(visible, table, 180, rgb(0,0,0), rgb(0,0,0), [], 7, 'TABLE').
default_look(visible, number, 250, rgb(0,0,0), rgb(0,0,0), [], 6, 'NUMBER').
default_look(visible, face_name, 250, rgb(128,128,128), rgb(128,128,128), [],
             6, 'FACE_NAME').
default_look(visible, angle, 180, rgb(128,128,128), rgb(128,128,128), [], 6,
             'ANGLE').
default_look(visible, bar, 250, rgb(0,0,0), rgb(0,0,0), [], 7, 'BAR').
default_look(visible, crop, 180, rgb(0,0,0), rgb(0,0,0), [], 7, 'CROP').
default_look(visible, grid, 100, rgb(190,190,190), rgb(190,190,190), [], 8,
             'GRID').

% --- random drawings ---------------------------------------------------------

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
                          symbol,axis]),
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

% --- each format -------------------------------------------------------------

pdf_case(Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(pdf, Drawing, Rows, [title('A\u00e9')], Text),
    read_pdf(Text, pdf("<FEFF004100E9>", Layers, [Page])),
    expected(drawn, Drawing, Looks, Lines),
    page_is(Page, Drawing, Lines),
    Page = page(_, _, [], Paths),
    layers_are(Layers, Lines, Paths).

layers_are(Layers, Lines, Paths) :-
    findall(Name, ( member(line(_,_,_,_,_,_,look(_,_,_,_,_,Name0),_), Lines),
                    atom_string(Name0, Name) ), Names0),
    findall(Name, member(path(Name,_,_,_,_,_,_), Paths), Names0),
    list_to_set(Names0, Names),
    subtract(Names, Layers, []).

page_is(page(W,H,_,Paths), drawing(sheet(W0,H0,_),_), Lines) :-
    abs(W-W0*72/25400) < 0.0006,
    abs(H-H0*72/25400) < 0.0006,
    maplist(path_is, Paths, Lines).

path_is(path(_,[R,G,B],Width,Cap,Runs,Offset,Points),
        line(_,_,_,_,_,Points0,look(Width0,_,rgb(R0,G0,B0),Runs0,_,_),
             Stroke)) :-
    maplist([X,N]>>( abs(X-N/255) =< 0.0005 ), [R,G,B], [R0,G0,B0]),
    abs(Width-Width0) =< 1,
    same_points(Points, Points0),
    (   Runs0 == []
    ->  Cap == 1,
        Runs == [],
        Offset =:= 0
    ;   Cap == 0,
        dashes_fit(Stroke, Runs0, Runs, Offset)
    ),
    !.
path_is(Path, Line) :-
    throw(wrong(path(Path, Line))).

same_points(Points, Points0) :-
    maplist([X-Y,X0-Y0]>>( abs(X-X0) =< 1, abs(Y-Y0) =< 1 ), Points, Points0).

ps_case(Kind, Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(Kind, Drawing, Rows, [title('a(b)')], Text),
    read_ps(Text, ps(Kind, "a(b)", Page)),
    expected(drawn, Drawing, Looks, Lines),
    page_is(Page, Drawing, Lines).

paper_case(Format, Seed) :-
    random_drawing(Seed, Drawing, Rows0, _),
    Drawing = drawing(sheet(W,H,_),_),
    written(Format, Drawing, [paper(rgb(250,128,1))|Rows0], [], Text),
    (   Format == pdf
    ->  read_pdf(Text, pdf(_, _, [page(_,_,Fills,_)]))
    ;   read_ps(Text, ps(_, _, page(_,_,Fills,_)))
    ),
    Fills = [fill([R,G,B],Corners)],
    maplist([X,N]>>( abs(X-N/255) =< 0.0005 ), [R,G,B], [250,128,1]),
    sort(Corners, Set),
    same_points(Set, [0-0,0-H,W-0,W-H]).

svg_case(Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(svg, Drawing, Rows, [title('a<b')], Text),
    Drawing = drawing(sheet(W,H,Scale),Views),
    read_svg(Text, svg(W,H,Scale,'a<b',rgb(255,255,255),Found,Texts)),
    expected(left, Drawing, Looks, Lines),
    maplist(svg_line_is, Found, Lines),
    findall(text(X,Y,Size,Anchor,String),
            ( member(view(_,_,Own), Views),
              member(text(X,Y,Height,Anchor,String), Own),
              Size is Height*100//72
            ),
            Texts).

svg_line_is(line(View,V,R,S,Edges,look(Screen,Width,Cap),Runs,Offset,Points),
            line(View,V,R,S,Edges,Points,look(Width,Screen,_,Runs0,_,_),
                 Stroke)) :-
    (   Runs0 == []
    ->  Runs == [],
        Cap == round
    ;   Cap == butt,
        dashes_fit(Stroke, Runs0, Runs, Offset)
    ),
    !.
svg_line_is(Found, Line) :-
    throw(wrong(line(Found, Line))).

json_case(Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(json, Drawing, Rows, [title('a"b')], Text),
    atom_json_dict(Text, Dict, []),
    Drawing = drawing(sheet(W,H,Scale),Views),
    Width is W/1000.0,
    Height is H/1000.0,
    _{title:"a\"b", unit:"mm", width:Width, height:Height, scale:Scale} :<
        Dict,
    expected(left, Drawing, Looks, Lines),
    maplist(json_line_is(Dict.styles), Dict.lines, Lines),
    findall(String, ( member(view(_,_,Own), Views),
                      member(text(_,_,_,_,String), Own) ), Strings),
    (   Strings == []
    ->  \+ get_dict(texts, Dict, _)
    ;   findall(String, ( member(T, Dict.texts), get_dict(text, T, String) ),
                Strings)
    ).

json_line_is(Styles, Found, line(View,V,R,S,Edges,Points,Look,Stroke)) :-
    Stroke = stroke(_,_,_,_,_,Start,End),
    atom_string(V, Visibility),
    atom_string(R, Role),
    atom_string(Start, Begins),
    atom_string(End, Ends),
    _{visibility:Visibility, role:Role, segment:S, edges:Edges, points:Mm,
      start:Begins, end:Ends, style:N} :< Found,
    (   View == ''
    ->  \+ get_dict(view, Found, _)
    ;   atom_string(View, Name),
        get_dict(view, Found, Name)
    ),
    maplist(thousandths, Mm, Points),
    Look = look(Width,rgb(Red,Green,Blue),_,Runs,Pen,Layer),
    nth0(N, Styles, Style),
    atom_string(Layer, LayerName),
    _{width:W, colour:Hex, dashes:Dashes, pen:Pen, layer:LayerName} :< Style,
    Width =:= round(W*1000),
    maplist([D,Run]>>( Run =:= round(D*1000) ), Dashes, Runs),
    format(string(Hex), '#~|~`0t~16r~2+~`0t~16r~2+~`0t~16r~2+',
           [Red,Green,Blue]),
    !.
json_line_is(_, Found, Line) :-
    throw(wrong(line(Found, Line))).

thousandths([X0,Y0], X-Y) :-
    X is round(X0*1000),
    Y is round(Y0*1000).

dxf_case(Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(dxf, Drawing, Rows, [], Text),
    Drawing = drawing(sheet(W,H,_),Views),
    read_dxf(Text, dxf(Header,_,Layers,Entities)),
    memberchk("$ACADVER"-[1-"AC1009"], Header),
    memberchk("$INSUNITS"-[70-"4"], Header),
    memberchk("$MEASUREMENT"-[70-"1"], Header),
    memberchk("$EXTMIN"-[10-"0.000",20-"0.000",30-"0.000"], Header),
    memberchk("$LIMMIN"-[10-"0.000",20-"0.000"], Header),
    memberchk("$EXTMAX"-[10-X,20-Y,30-"0.000"], Header),
    memberchk("$LIMMAX"-[10-X,20-Y], Header),
    maplist([A,N]>>( number_string(F, A), N =:= round(F*1000) ),
            [X,Y], [W,H]),
    expected(left, Drawing, Looks, Lines),
    length(Lines, Count),
    length(First, Count),
    append(First, Second, Entities),
    maplist(dxf_line_is(H), First, Lines),
    % a layer looks as its first line, or text, does
    findall(Layer-Colour-Runs,
            ( member(Entity, Entities),
              ( Entity = line(Layer,Colour,Runs,_,_)
              ; Entity = text(Layer,Colour,_,_,_,_), Runs = text ) ),
            Used),
    forall(( member(layer(Layer,Colour,_), Layers),
             memberchk(Layer-Found-_, Used) ),
           Found == Colour),
    findall(T, ( member(view(_,_,Own), Views), member(T, Own) ), Texts),
    maplist(dxf_text_is(H), Second, Texts).

dxf_line_is(H, line(Layer,Colour,Signed,Closed,Vertices),
            line(_,_,_,S,Edges,Points,look(_,Screen,_,Runs,_,Layer0),Stroke)) :-
    Stroke = stroke(_,_,_,_,_,Start,_),
    atom_string(Layer0, Layer),
    dxf_colour(Screen, Colour),
    signed(Runs, Signed),
    (   Start == ring
    ->  Closed == closed,
        append(Shown, [_], Points)
    ;   Closed == open,
        Shown = Points
    ),
    findall(X-Y, ( member(X-Y0, Shown), Y is H-Y0 ), Ups),
    findall(P, member(P-_, Vertices), Ups),
    findall(S-E, member(E, Edges), Data0),
    findall(D, ( member(_-D, Vertices), D \== none ), Data0),
    !.
dxf_line_is(_, Found, Line) :-
    throw(wrong(line(Found, Line))).

signed([], []).
signed([On,Off0|Runs], [On,Off|Signed]) :-
    Off is -Off0,
    signed(Runs, Signed).

dxf_text_is(H, text(_,_,X-Up,Height,Place,_), text(X,Y,Height,Anchor,_)) :-
    Up =:= H-Y,
    nth0(Place, [start,middle,end], Anchor),
    !.
dxf_text_is(_, Found, Text) :-
    throw(wrong(text(Found, Text))).

% Pens draw in an order and direction of their own: what lies on the paper is
% the same straight pieces.
hpgl_case(Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(hpgl, Drawing, Rows, [dashes(type)], Text),
    Drawing = drawing(sheet(W,H,_),_),
    read_hpgl(Text, hpgl(XW-YH,Pens,Pieces)),
    unit(W, XW),
    unit(H, YH),
    expected(drawn, Drawing, Looks, Lines),
    findall(Pen, member(line(_,_,_,_,_,_,look(_,_,_,_,Pen,_),_), Lines),
            Pens0),
    list_to_set(Pens0, Pens1),
    subtract(Pens1, Pens, []),
    Diagonal is sqrt(W*W+H*H),
    findall(piece(Pen,Type,A,B),
            ( member(line(_,_,_,_,_,Points,look(_,_,_,Runs,Pen,_),_), Lines),
              append(_, [P,Q|_], Points),
              maplist(units(H), [P,Q], Both),
              msort(Both, [A,B]),
              A \== B,
              (   Runs == []
              ->  Type = solid
              ;   sum_list(Runs, Period),
                  Type is round(100000*Period/Diagonal)
              )
            ),
            Wanted0),
    findall(piece(Pen,Type,A,B),
            ( member(piece(Pen,Type0,_,P,Q), Pieces),
              msort([P,Q], [A,B]),
              A \== B,
              (   Type0 == solid
              ->  Type = solid
              ;   Type0 = type(_,Percent),
                  Type is round(1000*Percent)
              )
            ),
            Found0),
    maplist(msort, [Wanted0,Found0], [Wanted,Found]),
    (   Wanted == Found
    ->  true
    ;   ord_subtract(Wanted, Found, Lost),
        ord_subtract(Found, Wanted, More),
        throw(wrong(pieces(lost(Lost), more(More))))
    ).

% The nearest, the upper one of two.
unit(N, Unit) :-
    Unit is floor(N/25+0.5).

units(H, X0-Y0, X-Y) :-
    Up is H-Y0,
    unit(X0, X),
    unit(Up, Y).

% Dashes that are drawn lie on their line, and begin where it begins.
hpgl_dashes_case(Seed) :-
    random_drawing(Seed, drawing(sheet(W,H,Scale),Views0), Rows, Looks),
    findall(view(Name,Strokes,[]), member(view(Name,Strokes,_), Views0), Views),
    Drawing = drawing(sheet(W,H,Scale), Views),
    written(hpgl, Drawing, Rows, [], Text),
    read_hpgl(Text, hpgl(none,_,Pieces)),
    unit(W, XW),
    unit(H, YH),
    forall(( member(piece(_,_,_,A,B), Pieces), member(X-Y, [A,B]) ),
           ( between(0, XW, X), between(0, YH, Y) )),
    expected(drawn, Drawing, Looks, Lines),
    findall(L, ( member(piece(_,solid,_,A,B), Pieces), length_of(A, B, L) ),
            Ls),
    sum_list(Ls, Found),
    findall(L, ( member(Line, Lines), drawn_length(Line, L) ), Ws),
    sum_list(Ws, Wanted0),
    Wanted is Wanted0/25,
    length(Pieces, Count),
    (   abs(Found-Wanted) =< 0.02*Wanted+1.5*Count
    ->  true
    ;   throw(wrong(lengths(Found, Wanted)))
    ).

length_of(X0-Y0, X1-Y1, L) :-
    L is sqrt((X1-X0)**2+(Y1-Y0)**2).

% How much of a line is drawn: the periods that fit it best.
drawn_length(line(_,_,_,_,_,Points,look(_,_,_,Runs,_,_),Stroke), Drawn) :-
    findall(L, ( append(_, [P,Q|_], Points), length_of(P, Q, L) ), Ls),
    sum_list(Ls, Length),
    (   Runs == []
    ->  Drawn = Length
    ;   Stroke = stroke(_,_,_,_,_,Start,End),
        Runs = [Dash,Gap|_],
        last(Runs, LastGap),
        sum_list(Runs, Period),
        findall(On, ( nth0(I, Runs, On), I mod 2 =:= 0 ), Ons),
        sum_list(Ons, On),
        (   Start == ring
        ->  Ends = 0,
            Inked = 0,
            Least = 1
        ;   findall(G, ( Start == cut, G = LastGap ; End == cut, G = Gap ), Gs),
            sum_list([Dash|Gs], Ends),
            Inked = Dash,
            Least = 0
        ),
        N is max(Least, round((Length-Ends)/Period)),
        Drawn is (N*On+Inked)*Length/(N*Period+Ends)
    ).

facts_case(Seed) :-
    random_drawing(Seed, Drawing, Rows, Looks),
    written(pl, Drawing, Rows, [], Text),
    setup_call_cleanup(open_string(Text, In), terms(In, Facts), close(In)),
    Drawing = drawing(sheet(W0,H0,Scale),_),
    W is W0/1000.0,
    H is H0/1000.0,
    Facts = [sheet(W,H,Scale)|_],
    expected(left, Drawing, Looks, Lines),
    findall(Fact, ( member(Fact, Facts), functor(Fact, stroke, 9) ), Found),
    maplist(fact_is(Facts), Found, Lines).

terms(In, Terms) :-
    read_term(In, Term, []),
    (   Term == end_of_file
    ->  Terms = []
    ;   Terms = [Term|Terms1],
        terms(In, Terms1)
    ).

fact_is(Facts, stroke(N,View,V,R,S,Edges,Mm,Start,End),
        line(View,V,R,S,Edges,Points,look(Width,Screen,_,Runs,Pen,Layer),
             stroke(_,_,_,_,_,Start,End))) :-
    memberchk(style(N,W,Screen,Dashes,Pen,Layer), Facts),
    Width =:= round(W*1000),
    maplist([D,Run]>>( Run =:= round(D*1000) ), Dashes, Runs),
    maplist([X0-Y0,X-Y]>>( X =:= round(X0*1000), Y =:= round(Y0*1000) ),
            Mm, Points),
    !.
fact_is(_, Found, Line) :-
    throw(wrong(line(Found, Line))).

% --- pictures ----------------------------------------------------------------

% A sheet of 20 x 15 mm, ten dots to a millimetre; rows of lists of RGB.
png_of(Strokes, Rows, Dots, png(W,H,Depth,Colour,Chunks,Bits)) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary), extension(png)]),
        ( write_drawing_stream(png, Out,
              [ drawing(drawing(sheet(20000,15000,1.0),
                                [view('',Strokes,[])])),
                style(Rows), dots(Dots) ]),
          close(Out),
          read_file_to_codes(File, Codes, [type(binary)])
        ),
        delete_file(File)),
    read_png(Codes, png(W,H,Depth,Colour,Chunks,Bits)).

png_size(Options, W, H) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary), extension(png)]),
        ( write_drawing_stream(png, Out, Options),
          close(Out),
          read_file_to_codes(File, Codes, [type(binary)])
        ),
        delete_file(File)),
    append(_, [0'I,0'H,0'D,0'R,0,0,W1,W0,0,0,H1,H0|_], Codes),
    W is 256*W1+W0,
    H is 256*H1+H0.

% How much of the paper is covered, in square thousandths of a millimetre.
ink_area(png(_,_,_,_,_,_), [], _, 0).
ink_area(Png, Rows, Dots, Area) :-
    darkness(Png, Rows, Sum),
    Area is Sum*(1000/Dots)**2.

% Of greys and colours: how far from white, 1 for black, summed.
darkness(png(_,_,8,Colour,Chunks,_), Rows, Sum) :-
    grey_table(Colour, Chunks, Table),
    foldl([Row,S0,S]>>foldl([B,T0,T]>>( arg_or_self(Table, B, D),
                                        T is T0+D ), Row, S0, S),
          Rows, 0, Sum).

grey_table(0, _, none).
grey_table(2, _, rgb).
grey_table(3, Chunks, Table) :-
    memberchk("PLTE"-Bytes, Chunks),
    greys(Bytes, Greys),
    Table =.. [table|Greys].

greys([], []).
greys([R,G,B|Bytes], [D|Greys]) :-
    D is 1-(R+G+B)/765,
    greys(Bytes, Greys).

arg_or_self(none, B, D) :-
    !,
    D is 1-B/255.
arg_or_self(rgb, B, D) :-
    !,
    D is (1-B/255)/3.
arg_or_self(Table, B, D) :-
    I is B+1,
    arg(I, Table, D).

:- begin_tests(written).

test(pdf, forall(seeds(Seed))) :-
    case(pdf, Seed, pdf_case(Seed)).
test(ps, forall(( seeds(Seed), member(Kind, [ps,eps]) ))) :-
    case(Kind, Seed, ps_case(Kind, Seed)).
test(paper, forall(( between(1, 3, Seed), member(Format, [pdf,ps,eps]) ))) :-
    case(Format, Seed, paper_case(Format, Seed)).
test(svg, forall(seeds(Seed))) :-
    case(svg, Seed, svg_case(Seed)).
test(json, forall(seeds(Seed))) :-
    case(json, Seed, json_case(Seed)).
test(dxf, forall(seeds(Seed))) :-
    case(dxf, Seed, dxf_case(Seed)).
test(hpgl, forall(seeds(Seed))) :-
    case(hpgl, Seed, hpgl_case(Seed)).
test(hpgl_dashes, forall(seeds(Seed))) :-
    case(hpgl, Seed, hpgl_dashes_case(Seed)).
test(facts, forall(seeds(Seed))) :-
    case(pl, Seed, facts_case(Seed)).

test(default_looks, forall(default_look(V,R,Width,Screen,Print,Runs,Pen,
                                        Layer))) :-
    Strokes = [stroke(V,R,0,[],[0-0,5000-0],joint,joint)],
    inked(drawing(sheet(9000,9000,1.0), [view('',Strokes,[])]), [],
          inked(_,Paper,[view('',[line(Ink,_)],[])])),
    Paper == rgb(255,255,255),
    ink_width(Ink, Width),
    ink_colour(screen, Ink, Screen),
    ink_colour(print, Ink, Print),
    ink_runs(Ink, Runs),
    ink_pen(Ink, Pen),
    ink_layer(Ink, Layer).
test(colour_names, true(Found == Named)) :-
    findall(Name-RGB, colour_name(Name, RGB), Found0),
    findall(Name-RGB, colour(Name, RGB), Named0),
    msort(Found0, Found),
    msort(Named0, Named).
test(line_types, true(Found == Named)) :-
    findall(Type-Runs, line_type(Type, 1, Runs), Found0),
    findall(Type-Runs, type(Type, Runs), Named0),
    msort(Found0, Found),
    msort([hidden-[3.0,0.9]|Named0], Named).

% Without a size: 210 x 148 mm, six dots to a millimetre of a smooth picture,
% 640 x 400 dots of one in dots.
test(default_size, forall(member(Options-W-H, [ []-1260-888,
                                                [png(dots)]-640-400 ]))) :-
    new_world(World),
    in_world(World, png_size(Options, W, H)).
test(default_sheet, Box == 210-148) :-
    new_world(World),
    in_world(World, with_output_to(string(Text),
                                   ( current_output(Out),
                                     write_drawing_stream(svg, Out, []) ))),
    read_svg(Text, svg(W,H,_,_,_,_,_)),
    A is W//1000,
    B is H//1000,
    Box = A-B.

% A line of a width covers its length times its width, and two half discs.
test(png_covers, [forall(member(P-Q, [ (3000-3000)-(17000-3000),
                                       (5000-2000)-(5000-12000),
                                       (3210-4130)-(16780-11090) ])),
                  true(Off =< 0.02)]) :-
    Dots = 10,
    Width = 900,
    png_of([stroke(visible,crease,1,[1],[P,Q],joint,joint)],
           [line(any,any,any,[width(0.9),colour(black)])], Dots, Png),
    Png = png(200, 150, 8, _, _, Rows),
    ink_area(Png, Rows, Dots, Area),
    length_of(P, Q, L),
    Wanted is L*Width+pi*Width*Width/4,
    Off is abs(Area-Wanted)/Wanted.

:- end_tests(written).
