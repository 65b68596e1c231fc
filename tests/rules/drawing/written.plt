:- encoding(utf8).
:- module(test_written, []).
% covers: drawing_json, pattern_look, hpgl, page, pdf, ps, svg
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(random)).
:- use_module(rules(drawing/drawing)).
:- use_module(rules(drawing/dxf_colour)).
:- use_module(rules(colour)).
:- use_module(rules(drawing/style)).
:- use_module(rules(drawing/ink)).
:- use_module(rules(sheet/lettering)).
:- use_module(rules(store)).
:- use_module(tests('rules/drawing/drawing_reader')).
:- use_module(default_look).
:- use_module(random_drawing).

/* Random drawings, written in every format, read by readers of our own
   (drawing_reader.pl): what is read is what was drawn, and every file is what
   its format says. */

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

png_sized(Wide-High, Dots, W, H) :-
    png_size([ drawing(drawing(sheet(Wide,High,1.0), [view('',[],[])])),
               dots(Dots) ], W, H).

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

% A picture has less than 2^31 dots a side, and no less than one.
test(largest, [ forall(( member(Size, [20000-15000,15000-20000]),
                         member(Times, [1,1.5,1.0e9]) )),
                error(domain_error(raster_size, W-H), _) ]) :-
    Size = Wide-High,
    Dots is Times*(1<<31)*1000/20000.0,
    W is round(Wide*Dots/1000),
    H is round(High*Dots/1000),
    png_sized(Size, Dots, _, _).
test(smallest, Sizes == [1/1,2/1,3/2]) :-
    findall(W/H, ( member(Dots, [0.001,0.1,0.15]),
                   png_sized(20000-11000, Dots, W, H) ), Sizes).

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
