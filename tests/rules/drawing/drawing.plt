:- encoding(utf8).
:- module(test_drawing, []).
% covers: drawing_facts
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(sgml)).
:- use_module(library(xpath)).
:- use_module(rules(store)).
:- use_module(rules(drawing/drawing)).
:- use_module(rules(command/verbs), [draw/1]).
:- use_module(rules(picture/hidden_lines), [picture/1]).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(penetration/penetration), [penetrate/0]).
:- use_module(rules(polygon/triangulation), [complete_segments/0]).

:- meta_predicate in_picture(+, 0).

% Goal in a new world with this picture: points V-X-Y, edges E-V1-V2, and
% drawn parts d(E,From,To,Visibility,Role).
in_picture(picture(Points, Edges, Drawn), Goal) :-
    new_world(World),
    in_world(World, ( picture_facts(Points, Edges, Drawn), Goal )).

picture_facts(Points, Edges, Drawn) :-
    assert_fact(segment(1, curve, test)),
    forall(member(V-X-Y, Points),
           ( assert_fact(v(1, V, X, Y, 0.0)),
             assert_fact(screen(1, V, X, Y, 0.0)) )),
    forall(member(E-V1-V2, Edges), assert_fact(e(1, E, V1, V2, 1))),
    forall(nth1(D, Drawn, d(E,From,To,Visibility,Role)),
           assert_fact(drawn(D, 1, E, From, To, Visibility, Role))).

% A unit square, its last side half hidden, a hidden penetration line across.
square(picture([1-0.0-0.0, 2-1.0-0.0, 3-1.0-1.0, 4-0.0-1.0],
               [1-1-2, 2-2-3, 3-3-4, 4-4-1, 5-1-3],
               [ d(1,0.0,1.0,visible,outline), d(2,0.0,1.0,visible,outline),
                 d(3,0.0,1.0,visible,outline), d(4,0.0,0.5,visible,outline),
                 d(4,0.5,1.0,hidden,outline), d(5,0.0,1.0,hidden,penetration)
               ])).

one_edge(X1-Y1, X2-Y2, picture([1-X1-Y1, 2-X2-Y2], [1-1-2],
                               [d(1,0.0,1.0,visible,outline)])).

drawing(Format, Options, Text) :-
    with_output_to(string(Text),
                   ( current_output(Out),
                     write_drawing_stream(Format, Out, Options) )).

svg(Options, DOM) :-
    drawing(svg, Options, Text),
    setup_call_cleanup(
        open_string(Text, In),
        load_structure(In, DOM, [dialect(xml)]),
        close(In)).

% class, data-edge and points of each line.
svg_line(DOM, line(Class, Edges, Points)) :-
    xpath(DOM, //(polyline), Line),
    xpath(Line, /self(@class), Class),
    xpath(Line, /self(@'data-edge'), Edges),
    xpath(Line, /self(@points), Points).

svg_lines(Options, Lines) :-
    svg(Options, DOM),
    findall(Line, svg_line(DOM, Line), Lines).

one_point(picture([1-3.0-4.0, 2-3.0-4.0], [1-1-2],
                  [d(1,0.0,1.0,visible,outline)])).

:- begin_tests(drawing).

test(square, true(Lines ==
        [ line('hidden outline', '4', '41,74 41,138'),
          line('hidden penetration', '5', '41,138 169,10'),
          line('visible outline', '1 2 3 4',
               '41,138 169,138 169,10 41,10 41,74')
        ])) :-
    square(Square),
    in_picture(Square, svg_lines([margin(10)], Lines)).
test(removed, true(Classes == ['visible outline'])) :-
    square(Square),
    in_picture(Square, svg_lines([margin(10),hidden(removed)], Lines)),
    findall(Class, member(line(Class,_,_), Lines), Classes).
test(removed_keeps_scale, true(Points == [ '41,138 169,138 169,10 \c
                                            41,10 41,74' ])) :-
    square(Square),
    in_picture(Square, svg_lines([margin(10),hidden(removed)], Lines)),
    findall(P, member(line(_,_,P), Lines), Points).
test(shown_is_not_dashed, true) :-
    square(Square),
    in_picture(Square, ( drawing(svg, [hidden(shown)], Shown),
                         drawing(svg, [], Dashed) )),
    \+ sub_string(Shown, _, _, _, dasharray),
    once(sub_string(Dashed, _, _, _, dasharray)).
test(hidden_option, error(domain_error(hidden_lines, no))) :-
    in_picture(picture([],[],[]), drawing(svg, [hidden(no)], _)).

test(head, true(Head == svg('210mm','148mm','0 0 210 148'))) :-
    in_picture(picture([],[],[]), svg([], DOM)),
    DOM = [element(_, Attributes, _)],
    memberchk(width=W, Attributes),
    memberchk(height=H, Attributes),
    memberchk(viewBox=Box, Attributes),
    Head = svg(W, H, Box).
test(size, [forall(member(Size, ['60x40.5', "60x40.5", 60-40.5])),
            true(W-H == '60mm'-'40.5mm')]) :-
    in_picture(picture([],[],[]), svg([size(Size)], [element(_, A, _)])),
    memberchk(width=W, A),
    memberchk(height=H, A).
test(bad_size, [forall(member(Size, [ '60', '60x', '0x5', 5-(-1), a4, 'axb',
                                      1e9-5 ])),
                error(domain_error(sheet_size, Size))]) :-
    in_picture(picture([],[],[]), drawing(svg, [size(Size)], _)).
test(scale, true(Size-Points == size('40mm','30mm')-'10,20 30,10')) :-
    one_edge(0.0-0.0, 2.0-1.0, Edge),
    in_picture(Edge, svg([scale(10)], DOM)),
    DOM = [element(_, A, _)],
    memberchk(width=W, A),
    memberchk(height=H, A),
    Size = size(W, H),
    once(svg_line(DOM, line(_,_,Points))).
test(empty, true(Lines == [])) :-
    in_picture(picture([],[],[]), svg_lines([], Lines)).
test(a_point, true(Lines == [])) :-
    one_point(Point),
    in_picture(Point, svg_lines([], Lines)).
test(flat_lying, true(Points == '10,74 200,74')) :-
    one_edge(-1.0-2.5, 7.0-2.5, Edge),
    in_picture(Edge, svg_lines([margin(10)], [line(_,_,Points)])).
test(flat_standing, true(Points == '105,10 105,138')) :-
    one_edge(0.1-1.0, 0.1-0.0, Edge),
    in_picture(Edge, svg_lines([margin(10)], [line(_,_,Points)])).
test(tiny, true(Points == '10,74 200,74')) :-
    one_edge(0.0-0.0, 1.0e-280-0.0, Edge),
    in_picture(Edge, svg_lines([margin(10)], [line(_,_,Points)])).
test(huge, true(Points == '10,74 200,74')) :-
    one_edge(-1.0e90-0.0, 1.0e90-0.0, Edge),
    in_picture(Edge, svg_lines([margin(10)], [line(_,_,Points)])).
test(no_minus_zero, true) :-
    one_edge(-0.00001-1.0, 0.00001-(-1.0), Edge),
    in_picture(Edge, drawing(svg, [scale(0.001),margin(1)], Text)),
    \+ sub_string(Text, _, _, _, "-0").
test(escaped, true(Title == '<a> & "b" ␁상관')) :-
    in_picture(picture([],[],[]),
               svg([title('<a> & "b" \u0001상관')], DOM)),
    once(xpath(DOM, //title(text), Title)).
test(ids_differ, true(Ids == ['s1e1', 's1e1-2', 's1e1-3'])) :-
    in_picture(picture([1-0.0-0.0, 2-1.0-1.0], [1-1-2],
                       [ d(1,0.0,0.2,visible,outline),
                         d(1,0.2,0.6,hidden,outline),
                         d(1,0.6,1.0,visible,outline) ]),
               svg([], DOM)),
    findall(Id, ( xpath(DOM, //polyline, Line), xpath(Line, /self(@id), Id) ),
            Ids0),
    msort(Ids0, Ids).
test(order_of_facts, true(Text == Again)) :-
    square(picture(Points, Edges, Drawn)),
    in_picture(picture(Points, Edges, Drawn), drawing(svg, [], Text)),
    reverse(Drawn, Drawn1),
    reverse(Edges, Edges1),
    in_picture(picture(Points, Edges1, Drawn1), drawing(svg, [], Again)).

% A whole number of dashes fits, and they are not stretched much.
test(dashes_fit, forall(member(L, [1,3,4,17,100,101,102,103,5000]))) :-
    X is float(L),
    in_picture(picture([1-0.0-0.0, 2-X-0.0], [1-1-2],
                       [d(1,0.0,1.0,hidden,outline)]),
               svg([scale(1)], DOM)),
    once(xpath(DOM, //polyline(@style), Style)),
    atomic_list_concat(['stroke-dasharray', Runs], :, Style),
    atomic_list_concat([DashText,GapText], ' ', Runs),
    atom_number(DashText, Dash),
    atom_number(GapText, Gap),
    N is (L+Gap)/(Dash+Gap),
    abs(N-round(N)) < 0.001*L/Dash + 0.01,
    Dash < 5.

test(json, true(Lines == [ "hidden"-[4], "hidden"-[5],
                           "visible"-[1,2,3,4] ])) :-
    square(Square),
    in_picture(Square, drawing(json, [title('a "b"')], Text)),
    atom_json_dict(Text, Dict, []),
    _{title:"a \"b\"", unit:"mm", width:210.0, height:148.0} :< Dict,
    findall(V-Es, ( member(Line, Dict.lines),
                    _{visibility:V, edges:Es, role:_, segment:1,
                      points:_, start:_, end:_} :< Line ),
            Lines).
test(json_empty, true(Lines == [])) :-
    in_picture(picture([],[],[]), drawing(json, [], Text)),
    atom_json_dict(Text, Dict, []),
    get_dict(lines, Dict, Lines).
test(png, true(Codes == [137,80,78,71,13,10,26,10,0,0,0,13])) :-
    square(Square),
    in_picture(Square, dots_codes([size(64-40)], All)),
    length(Codes, 12),
    append(Codes, _, All),
    nth0(19, All, 64),
    nth0(23, All, 40).
test(png_same_bytes, [forall(member(How, [smooth,dots])), true(A == B)]) :-
    square(Square),
    in_picture(Square, ( png_codes([png(How)], A), png_codes([png(How)], B) )).
test(png_empty, forall(member(How, [smooth,dots]))) :-
    in_picture(picture([],[],[]), png_codes([png(How)], [_|_])).
test(png_smooth_size, true(W-H == 210-74)) :-
    square(Square),
    in_picture(Square, png_codes([size(105-37),dots(2)], Codes)),
    nth0(19, Codes, W),
    nth0(23, Codes, H).
test(bad_png, error(domain_error(png, rough))) :-
    square(Square),
    in_picture(Square, png_codes([png(rough)], _)).
test(bad_pattern, [forall(member(P, [0, -1, a, [1], [1,0], []])),
                   error(domain_error(dot_pattern, P))]) :-
    square(Square),
    in_picture(Square, dots_codes([pattern(P)], _)).
test(png_too_large, error(domain_error(raster_size, _))) :-
    in_picture(picture([],[],[]), dots_codes([size(50000-50000)], _)).

% Code-Value of each group of a DXF file.
dxf_groups(Options, Groups) :-
    drawing(dxf, Options, Text),
    split_string(Text, "\n", " ", Lines),
    groups(Lines, Groups).

groups([""], []).
groups([Code0,Value|Lines], [Code-Value|Groups]) :-
    number_string(Code, Code0),
    groups(Lines, Groups).

test(dxf, true(Kinds == [ "SECTION", "ENDSEC", "SECTION", "TABLE", "LTYPE",
                          "LTYPE", "ENDTAB", "TABLE", "LAYER", "LAYER",
                          "LAYER", "LAYER", "ENDTAB", "TABLE", "APPID",
                          "ENDTAB",
                          "ENDSEC", "SECTION",
                          "LINE", "LINE",
                          "POLYLINE", "VERTEX", "VERTEX", "VERTEX", "VERTEX",
                          "VERTEX", "SEQEND", "ENDSEC", "EOF" ])) :-
    square(Square),
    in_picture(Square, dxf_groups([], Groups)),
    findall(Kind, member(0-Kind, Groups), Kinds).
test(dxf_layers, true(Layers == ["0", "HIDDEN_OUTLINE", "HIDDEN_PENETRATION",
                                 "VISIBLE_OUTLINE"])) :-
    square(Square),
    in_picture(Square, dxf_groups([], Groups)),
    findall(Layer, append(_, [0-"LAYER",2-Layer|_], Groups), Layers).
test(dxf_y_is_up, true(X-Y == "41.000"-"10.000")) :-
    square(Square),
    in_picture(Square, dxf_groups([margin(10),hidden(removed)], Groups)),
    once(append(_, [0-"VERTEX",_,10-X,20-Y|_], Groups)).
% What would be read as something else: %%d is a degree, \U+ a character.
test(dxf_text,
     Text == "a\\U+0025\\U+0025d \\U+AC00\\U+D83D\\U+DE00\\U+005CU+") :-
    Drawing = drawing(sheet(100 000,100 000,1.0),
                      [view('', [], [text(0,0,5000,start,Written)])]),
    Written = "a%%d \uAC00\U0001F600\\U+",
    in_picture(picture([],[],[]), dxf_groups([drawing(Drawing)], Groups)),
    append(_, [0-"TEXT"|Rest], Groups),
    !,
    memberchk(1-Text, Rest).
test(dxf_layers_once, Layers == ["ABC","0"]) :-
    square(Square),
    Style = [ line(visible,any,any,[layer('0')]),
              line(hidden,any,any,[layer('aBc')]) ],
    in_picture(Square, dxf_groups([style(Style)], Groups)),
    findall(Layer, append(_, [0-"LAYER",2-Layer|_], Groups), Layers).
test(ps_title, true(Most < 256)) :-
    length(Codes, 1000),
    maplist(=(0'x), Codes),
    atom_codes(Title, Codes),
    in_picture(picture([],[],[]), drawing(eps, [title(Title)], Text)),
    split_string(Text, "\n", "", Lines),
    findall(N, ( member(Line, Lines), string_length(Line, N) ), Ns),
    max_list(Ns, Most).
test(no_size, [forall(member(Size, ['0.0001x5',0-5,5- -1])),
               error(domain_error(sheet_size, _))]) :-
    in_picture(picture([],[],[]), drawing(svg, [size(Size)], _)).
test(no_scale, [forall(member(Scale, [0,-1])),
                error(domain_error(positive_scale, _))]) :-
    square(Square),
    in_picture(Square, drawing(svg, [scale(Scale)], _)).

test(dxf_empty, true(Last == 0-"EOF")) :-
    in_picture(picture([],[],[]), dxf_groups([], Groups)),
    last(Groups, Last).
test(hpgl, true(Lines == [ "IN;", "PS8400,5920;", "PU;SP1;",
                           "CO \"s1e1 visible outline\";",
                           "PU400,2960;PD8000,2960;", "PU;SP0;", "" ])) :-
    one_edge(-1.0-2.5, 7.0-2.5, Edge),
    in_picture(Edge, drawing(hpgl, [margin(10)], Text)),
    split_string(Text, "\n", "", Lines).

% What is shorter than a unit of 0.025 mm is not drawn: the edge from 2 to 3.
test(hpgl_short, true(Downs == ["PD8000,2960;"])) :-
    in_picture(picture([1-0.0-0.0, 2-100.0-0.0, 3-100.0-0.005, 4-50.0-0.0],
                       [1-1-2, 2-2-3],
                       [ d(1,0.0,1.0,visible,outline),
                         d(2,0.0,1.0,hidden,crease) ]),
               drawing(hpgl, [margin(10),hidden(shown)], Text)),
    split_string(Text, "\n", "", Lines),
    findall(Down, ( member(Line, Lines), sub_string(Line, At, _, _, "PD"),
                    sub_string(Line, At, _, 0, Down) ),
            Downs).
test(hpgl_pen_stays_down, true(Downs == ["PD6568,5328;"])) :-
    square(Square),
    in_picture(Square, drawing(hpgl, [hidden(shown)], Text)),
    split_string(Text, "\n", "", Lines),
    findall(Line, ( member(Line, Lines), string_concat("PD", _, Line) ),
            Downs).

dots_codes(Options, Codes) :-
    png_codes([png(dots)|Options], Codes).

png_codes(Options, Codes) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary), extension(png)]),
        ( write_drawing_stream(png, Out, Options),
          close(Out),
          read_file_to_codes(File, Codes, [type(binary)])
        ),
        delete_file(File)).

% The facts that a drawing is written as.
facts(Options, Facts) :-
    drawing(pl, Options, Text),
    setup_call_cleanup(
        open_string(Text, In),
        ( read_term(In, First, []), terms(First, In, Facts) ),
        close(In)).

terms(end_of_file, _, []) :-
    !.
terms(Term, In, [Term|Terms]) :-
    read_term(In, Next, []),
    terms(Next, In, Terms).

written_row(segment, segment(_,_,_)).
written_row(screen,  screen(_,_,_,_,_)).
written_row(e,       e(_,_,_,_,_)).
written_row(contour, contour(_,_,_,_,_,_,_,_,_,_,_,_,_)).
written_row(origin,  origin(_,_,_)).
written_row(line,    line(_,_,_,_,_,_,_,_,_)).
written_row(drawn,   drawn(_,_,_,_,_,_,_)).

needed_rows(Name, Rows) :-
    written_row(Name, Row),
    findall(Row, ( Row, needed_row(Row) ), Rows0),
    sort(Rows0, Rows).

needed_row(segment(S,_,_)) :-
    once(drawn(_,S,_,_,_,_,_)).
needed_row(screen(S,V,_,_,_)) :-
    drawn_end(S, V).
needed_row(e(S,E,_,_,_)) :-
    once(drawn(_,S,E,_,_,_,_)).
needed_row(contour(S,K,_,_,_,_,_,_,_,_,_,_,_)) :-
    E is -K,
    once(drawn(_,S,E,_,_,_,_)).
needed_row(origin(S,v(V),_)) :-
    drawn_end(S, V).
needed_row(line(_,_,_,_,_,_,_,_,_)).
needed_row(drawn(_,_,_,_,_,_,_)).

drawn_end(S, V) :-
    drawn(_, S, E, _, _, _, _),
    E > 0,
    e(S, E, V1, V2, _),
    ( V == V1 ; V == V2 ),
    !.

test(facts, true(Counts == [ segment-1, view-0, screen-4, e-5, drawn-6, sheet-1,
                             style-3, stroke-3 ])) :-
    square(Square),
    in_picture(Square, facts([], Facts)),
    findall(Name-Count,
            ( member(Name, [segment,view,screen,e,drawn,sheet,style,stroke]),
              aggregate_all(count, ( member(Fact, Facts),
                                     functor(Fact, Name, _) ), Count) ),
            Counts).
test(facts_of_a_line, true(Found == [4-[41.0-74.0, 41.0-138.0]])) :-
    square(Square),
    in_picture(Square, facts([margin(10)], Facts)),
    findall(E-Points,
            member(stroke(_,'',hidden,outline,1,[E],Points,_,_), Facts),
            Found).
% Every row that the picture needs, once, in the order of its key.
test(facts_of_a_model, true(Wrong == [])) :-
    new_world(World),
    in_world(World,
             ( add_primitive(sphere(radius(1), facets(20), bands(10)), _),
               add_primitive(at([translate(0.5,0.4,0.3)],
                                box(size(1,1,1))), _),
               add_primitive(at([translate(9,9,9)], box(size(1,1,1))), _),
               complete_segments,
               penetrate,
               picture([segments([1,2])]),
               facts([], Facts),
               findall(Name,
                       ( written_row(Name, Row),
                         findall(Row, member(Row, Facts), Written),
                         ( needed_rows(Name, Needed),
                           Written == Needed,
                           Needed \== []
                         -> fail ; true ) ),
                       Wrong) )).
test(facts_of_a_drawing, true(Facts ==
        [ sheet(40.0,30.0,2.0), style(1,0.35,rgb(0,0,0),[],1,'TEXT'),
          text(1,a,1.5,2.0,3.5,end,"A\uAC00") ])) :-
    facts([drawing(drawing(sheet(40000,30000,2.0),
                           [view(a,[],[text(1500,2000,3500,end,
                                            "A\uAC00")])]))],
          Facts).
test(pdf_offsets, forall(member(Title, ['', 'a (b) \uC0C1']))) :-
    square(Square),
    in_picture(Square, drawing(pdf, [title(Title)], Text)),
    split_string(Text, "\n", "", Lines),
    append(_, ["startxref",At0|_], Lines),
    !,
    number_string(At, At0),
    sub_string(Text, At, 4, _, "xref"),
    forall(( member(Line, Lines),
             string_concat(Offset0, " 00000 n ", Line) ),
           ( number_string(Offset, Offset0),
             sub_string(Text, Offset, 8, _, Object),
             sub_string(Object, _, _, _, " 0 obj") )).
test(pdf_title, true) :-
    in_picture(picture([],[],[]), drawing(pdf, [title('\uC0C1\U0001F600')], T)),
    once(sub_string(T, _, _, _, "<FEFFC0C1D83DDE00>")).
test(ps_title_is_ascii, true) :-
    in_picture(picture([],[],[]), drawing(eps, [title('a\n\uC0C1')], Text)),
    once(sub_string(Text, _, _, _, "%%Title: a??\n")).
test(shown_in_all, [forall(member(Format, [svg,pdf,eps,dxf])),
                    true(Shown \== Dashed)]) :-
    square(Square),
    in_picture(Square, ( drawing(Format, [hidden(shown)], Shown),
                         drawing(Format, [], Dashed) )),
    forall(member(Word, ["dasharray", "HIDDEN\n 70"]),
           \+ sub_string(Shown, _, _, _, Word)).
test(geometry_has_no_dashes, forall(member(Format-Word,
        [ svg-"dasharray", pdf-"] 0 d [", eps-"] 0 d [",
          dxf-"HIDDEN\n 70" ]))) :-
    square(Square),
    in_picture(Square, drawing(Format, [dashes(geometry)], Text)),
    \+ sub_string(Text, _, _, _, Word).
test(bad_dashes, [forall(member(Format, [svg,pdf,eps,dxf,hpgl])),
                  error(domain_error(dashes, wavy))]) :-
    in_picture(picture([],[],[]), drawing(Format, [dashes(wavy)], _)).

% Length of each visibility and role, in the picture and in the drawing.
drawn_lengths(Lengths) :-
    findall(Kind-L,
            ( drawn(_, S, E, From, To, Visibility, Role),
              Kind = Visibility-Role,
              e(S, E, V1, V2, _),
              screen(S, V1, X1, Y1, _),
              screen(S, V2, X2, Y2, _),
              L is (To-From)*sqrt((X2-X1)**2 + (Y2-Y1)**2)
            ),
            Pairs),
    summed(Pairs, Lengths).

json_lengths(Lengths) :-
    drawing(json, [size(2000-2000)], Text),
    atom_json_dict(Text, Dict, []),
    get_dict(scale, Dict, Scale),
    get_dict(lines, Dict, Lines),
    findall(Kind-L,
            ( member(Line, Lines),
              _{visibility:V, role:R, points:Points} :< Line,
              atom_string(Visibility, V),
              atom_string(Role, R),
              Kind = Visibility-Role,
              append(_, [[X1,Y1],[X2,Y2]|_], Points),
              L is sqrt((X2-X1)**2 + (Y2-Y1)**2)/Scale
            ),
            Pairs),
    summed(Pairs, Lengths).

summed(Pairs, Sums) :-
    keysort(Pairs, Sorted),
    group_pairs_by_key(Sorted, Groups),
    findall(Kind-Sum, ( member(Kind-Ls, Groups), sum_list(Ls, Sum) ), Sums).

same_lengths([], []).
same_lengths([Kind-A|As], [Kind-B|Bs]) :-
    abs(A-B) =< 1.0e-3,
    same_lengths(As, Bs).

test(nothing_lost, forall(member(Name, [fig09, fig10, fig11, fig13, fig14]))) :-
    format(atom(Path), 'facts/figures/~w.pl', [Name]),
    absolute_file_name(sanggwan(Path), File),
    new_world(World),
    in_world(World, ( load_model(File),
                      penetrate,
                      picture([lines(all)]),
                      drawn_lengths(Drawn),
                      json_lengths(Json) )),
    same_lengths(Drawn, Json).

test(files, [forall(drawing_format(Format, _)), true]) :-
    square(Square),
    tmp_file(drawing, Base),
    file_name_extension(Base, Format, File),
    call_cleanup(
        ( in_picture(Square, write_drawing(File, [])),
          size_file(File, Size),
          Size > 100
        ),
        delete_file(File)).
test(ending, error(domain_error(drawing_format, gif))) :-
    write_drawing('a.gif', []).
test(text_stream_gets_bytes, true(Encoding == utf8)) :-
    square(Square),
    tmp_file_stream(File, Out, [encoding(utf8)]),
    call_cleanup(
        ( in_picture(Square, write_drawing_stream(png, Out, [])),
          stream_property(Out, encoding(Encoding)),
          close(Out),
          read_file_to_codes(File, [137,80|_], [type(binary)])
        ),
        delete_file(File)).

% A picture is no step to undo: what was done before it is.
test(undo_after_draw) :-
    tmp_file(drawn, Base),
    atom_concat(Base, '.svg', File),
    new_world(World),
    in_world(World,
             ( add_primitive(box(size(1,1,1)), S),
               facts_transaction(retract_fact(p(S, 6, _))),
               draw(File),
               once(drawn(_,_,_,_,_,_,_)),
               facts_undo,
               once(p(S, 6, _)) )).

:- end_tests(drawing).
