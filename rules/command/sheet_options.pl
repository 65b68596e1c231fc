:- module(sg_sheet_options,
          [ sheet_wanted/1,             % +Options
            cutaway_wanted/2,           % +Options, -Text
            sheet_request/3,            % +Options, +Picture, -Request
            request_facts/4,            % +Options, +Files, +Request0,
                                        % -Request
            request_title/2,            % +Request, -Title
            looking/2,                  % +Options, -View
            view_told/2,                % +Text, -View
            points_wanted/2,            % +Options, -Most
            scale_option/2              % +Options, -Millimetres
          ]).
:- use_module('../decimal', [decimal_number/2]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../sheet/sheet_paper',
              [ paper/3, paper_size/3, scale_factor/2, unit_millimetres/2 ]).
:- use_module('../sheet/sheet_view', [view_named/2, view_towards/3]).
:- use_module('../sheet/title_block', [title_block_read/2]).
:- use_module('../store', [title_block/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(apply), [maplist/2, maplist/3, maplist/4]).
:- use_module(library(lists), [append/3, member/2, memberchk/2, select/3]).
:- use_module(library(option), [option/2, option/3]).
/** <module> What the options of `draw` say of the sheet.

Every mistake is found before the model is read, except what depends on it.
*/

%!  sheet_wanted(+Options) is semidet.
%
%   True when Options ask for a sheet with a frame or for more than one view.

sheet_wanted(Options) :-
    member(Name, [sheet,views,section,'title-block',angle,'no-frame']),
    Option =.. [Name,_],
    memberchk(Option, Options),
    !.

%!  cutaway_wanted(+Options, -Text) is semidet.
%
%   Options ask for a picture of the model cut open by the plane that Text says,
%   see cutaway/5.
%
%   @error usage_error(bad_value('--cutaway', Text, Form)),
%   usage_error(both_options(A, B))

cutaway_wanted(Options, Text) :-
    option(cutaway(Text), Options),
    forall(( member(Name, [ sheet,views,section,'title-block',angle,'no-frame',
                            explode,shade,points,'centre-lines' ]),
             Option =.. [Name,_] ),
           ( atom_concat(--, Name, Other),
             apart(Options, Option, '--cutaway', Other) )),
    apart(Options, projection(central), '--cutaway', '--projection central'),
    (   plane_form(Text)
    ->  true
    ;   usage_error(bad_value('--cutaway', Text,
                              'x=5, y=5, z=5, x, y, z or A,B,C,D'))
    ).

%!  sheet_request(+Options, +Picture, -Request) is det.
%
%   Request, for views_drawing/5, is what Options ask for; Picture are options
%   of picture/1. The facts of the title block are not yet in it.
%
%   @error usage_error(What)

sheet_request(Options, Picture,
              [ paper(Width,Height), views(Views), sections(Sections),
                angle(Angle), scale(Scale), unit(Unit), frame(Frame),
                hidden(Hidden), picture(Picture)|Numbered
              ]) :-
    apart(Options, size(_), '--size', '--sheet'),
    apart(Options, projection(central), '--projection central', '--sheet'),
    option(sheet(Paper), Options, 'A3'),
    paper_option(Paper, Width, Height),
    views_option(Options, Views),
    option(section(Sections), Options, []),
    maplist(section_form, Sections),
    option(angle(Angle), Options, third),
    option(scale(ScaleText), Options, standard),
    scale_form(ScaleText, Scale),
    unit_option(Options, Unit),
    (   option('no-frame'(true), Options)
    ->  Frame = false
    ;   Frame = true
    ),
    option(hidden(Hidden), Options, usual),
    findall(points(Most), points_wanted(Options, Most), Numbered).

%!  points_wanted(+Options, -Most) is semidet.
%
%   Points of penetration lines are to have numbers, at most Most of a line, or
%   `all`.
%
%   @error usage_error(bad_value('--points', Text, Form))

points_wanted(Options, Most) :-
    option(points(Text), Options),
    (   Text == all
    ->  Most = all
    ;   (   integer(Text)
        ->  Most = Text
        ;   atom(Text),
            atom_number(Text, Most)
        ),
        integer(Most),
        Most >= 1
    ->  true
    ;   usage_error(bad_value('--points', Text, 'N, all (N >= 1)'))
    ).

apart(Options, Option, A, B) :-
    (   memberchk(Option, Options)
    ->  usage_error(both_options(A, B))
    ;   true
    ).

paper_option(Text, Width, Height) :-
    (   paper(Text, Width, Height)
    ->  true
    ;   findall(Name, paper_size(Name, _, _), Names),
        usage_error(sheet(paper(Text, Names)))
    ).

%   The four that say most of a part, if nothing is said.

views_option(Options, Views) :-
    (   option(views(Text), Options)
    ->  (   looking_option(Options, Name, _)
        ->  usage_error(both_options('--views', Name))
        ;   true
        ),
        split_string(Text, ",", " ", Names),
        maplist(view_option, Names, Views),
        each_once(Views)
    ;   looking(Options, View)
    ->  Views = [View]
    ;   maplist(view_named, [front,top,right,isometric], Views)
    ).

view_option(Text, View) :-
    atom_string(Name0, Text),
    downcase_atom(Name0, Name),
    (   view_named(Name, View)
    ->  true
    ;   findall(Known, view_named(Known, _), All),
        usage_error(sheet(view(Text, All)))
    ).

%   iso and isometric are one.

each_once(Views) :-
    (   select(view(Name,Theta,Phi,_), Views, Others),
        memberchk(view(_,Theta,Phi,_), Others)
    ->  usage_error(sheet(view_twice(Name)))
    ;   true
    ).

%   What can be seen of a section without the model.

section_form(Text) :-
    (   plane_form(Text)
    ->  true
    ;   usage_error(sheet(section(Text)))
    ).

plane_form(Text) :-
    split_string(Text, "=", " ", [Axis|Value]),
    member(Axis, ["x","y","z","X","Y","Z"]),
    (   Value = []
    ;   Value = [Number],
        decimal_number(Number, _)
    ),
    !.
plane_form(Text) :-
    vector(4, Text, [A,B,C,_]),
    \+ maplist(=:=(0), [A,B,C]).

vector(N, Text, Numbers) :-
    split_string(Text, ",", " ", Parts),
    length(Parts, N),
    maplist(decimal_number, Parts, Numbers).

scale_form(Text, Scale) :-
    (   memberchk(Text, [standard,fit])
    ->  Scale = Text
    ;   split_string(Text, ":", " ", [TextN,TextM]),
        decimal_number(TextN, N),
        decimal_number(TextM, M),
        N > 0,
        M > 0,
        catch(scale_factor(N:M, Factor), error(evaluation_error(_), _), fail),
        Factor > 1.0e-150,
        Factor < 1.0e150
    ->  Scale = N:M
    ;   usage_error(sheet(scale(Text)))
    ).

unit_option(Options, Millimetres) :-
    option(unit(Unit), Options, mm),
    unit_millimetres(Unit, Millimetres).

%!  scale_option(+Options, -Millimetres) is semidet.
%
%   A unit of the model is Millimetres on a sheet without a frame. Fails if the
%   picture is to fill the sheet.

scale_option(Options, Millimetres) :-
    option(scale(Text), Options),
    scale_form(Text, Scale),
    Scale = _:_,
    scale_factor(Scale, Factor),
    unit_option(Options, Unit),
    Millimetres is Factor*Unit.


                /*******************************
                *        WHERE ONE LOOKS       *
                *******************************/

%!  looking(+Options, -View) is semidet.
%
%   View (sheet_view.pl) is how --view or --direction say; eye(Eye,Target), for
%   eye.pl, is how --eye says. Fails if there is none of them.
%
%   @error usage_error(What)

looking(Options, View) :-
    findall(Name-Value, looking_option(Options, Name, Value), Found),
    (   Found = [A-_,B-_|_]
    ->  usage_error(both_options(A, B))
    ;   option(target(_), Options),
        Found \= ['--eye'-_]
    ->  usage_error(needs_one_of(['--eye']))
    ;   Found = [Name-Value],
        looking_view(Name, Value, Options, View)
    ).

looking_option(Options, '--view', Value) :-
    option(view(Value), Options).
looking_option(Options, '--direction', Value) :-
    option(direction(Value), Options).
looking_option(Options, '--eye', Value) :-
    option(eye(Value), Options).

looking_view('--view', Text, _, View) :-
    view_told(Text, View).
looking_view('--direction', Text, _, View) :-
    vector_option('--direction', Text, [X,Y,Z]),
    direction_view('--direction', Text, d(X,Y,Z), View).
looking_view('--eye', Text, Options, eye(Eye,Target)) :-
    vector_option('--eye', Text, Eye),
    (   option(target(TargetText), Options)
    ->  vector_option('--target', TargetText, Target)
    ;   Target = middle
    ).

%!  view_told(+Text, -View) is det.
%
%   View is how `--view Text` looks.
%
%   @error usage_error(sheet(no_view(Text, Near, Names)))

view_told(Text, View) :-
    (   downcase_atom(Text, Name),
        view_named(Name, View0)
    ->  View = View0
    ;   split_string(Text, ",", " ", Parts),
        maplist(decimal_number, Parts, [Theta,Phi|Rho]),
        (   Rho = []
        ;   Rho = [R],
            R >= 0
        )
    ->  View = view(view,Theta,Phi,pictorial)
    ;   findall(Name, view_named(Name, _), Names),
        near_words(Text, Names, Near),
        usage_error(sheet(no_view(Text, Near, Names)))
    ).

vector_option(Name, Text, Numbers) :-
    (   vector(3, Text, Numbers0)
    ->  Numbers = Numbers0
    ;   usage_error(bad_value(Name, Text, 'X,Y,Z'))
    ).

direction_view(Name, Text, Direction, View) :-
    (   view_towards(Direction, view, View0)
    ->  View = View0
    ;   usage_error(sheet(no_direction(Name, Text)))
    ).


                /*******************************
                *          TITLE BLOCK         *
                *******************************/

%!  request_facts(+Options, +Files, +Request0, -Request) is det.
%
%   Request is Request0 with what the title block says: what --title-block
%   names, or else the model (title_block/2), or for the name of the part the
%   first of Files. Its language is that of --language, else of --lang, else
%   English: a drawing does not follow the environment.
%
%   @error model_error(What)

request_facts(Options, Files, Request, [facts([language-Language|Facts])
                                       |Request]) :-
    option(lang(Spoken), Options, en),
    option(language(Language), Options, Spoken),
    (   option('title-block'(File), Options)
    ->  title_block_read(File, Own)
    ;   Own = []
    ),
    findall(Item-Text, title_block(Item, Text), Model),
    file_name(Files, Name),
    append(Own, Model, Given0),
    append(Given0, [name-Name], Given),
    findall(Item-String,
            ( member(Item-Text, Given), shown_text(Text, String) ),
            Facts).

%!  request_title(+Request, -Title) is det.
%
%   Title, a string, is the name in the title block of Request.

request_title(Request, Title) :-
    option(facts(Facts), Request),
    memberchk(name-Title, Facts).

%   shown_text(Text, String): on one line.

shown_text(Text, String) :-
    format(codes(Codes0), '~w', [Text]),
    maplist(shown_code, Codes0, Codes),
    string_codes(String, Codes).

shown_code(Code0, Code) :-
    (   Code0 < 32
    ->  Code = 32
    ;   Code = Code0
    ).

file_name([File|_], Name) :-
    File \== '-',
    !,
    file_base_name(File, Base),
    file_name_extension(Name, _, Base).
file_name(_, '').
