:- module(sg_laid_out,
          [ sheet_laid/4,               % +Head, +Makers, -Reply, -Octets
            shaded/4,                   % +Head, +Makers, -Reply, -Octets
            unfolded/4,                 % +Head, +Makers, -Reply, -Octets
            folded/4                    % +Head, +Makers, -Reply, -Octets
          ]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../output', [copied_to/3]).
:- use_module('../pattern/fold_file', [write_fold/3]).
:- use_module('../pattern/pattern_drawing', [pattern_drawing/3]).
:- use_module('../solid/trimmed', [part_named/2]).
:- use_module('../store', [e/5, segment/3]).
:- use_module('../unfolding/unfold', [pattern_of/2]).
:- use_module(document, [document_file/1, document_world/1]).
:- use_module(job, [captured/2]).
:- use_module(port, [drawing_body/3, strokes_body/4]).
:- use_module(request, [request_error/1, request_options/2]).
:- use_module(world_state, [in_state/3, made_once/4]).
:- use_module(library(apply), [foldl/4, maplist/4]).
:- use_module(library(lists),
              [append/2, append/3, member/2, min_list/2, nth1/3]).
/** <module> What a session lays out: sheets, patterns, pictures.

Makers is that of session/4 (session.pl); what they make is kept with the
revision. Head is that of the request, Reply and Octets are what it is answered.
*/

%!  sheet_laid(+Head:dict, +Makers, -Reply:dict, -Octets) is det.
%
%   The drawing on paper, as strokes; or what pens draw of it, in their order.
%
%   @error request_error(bad_key(Key, What)), and those of the maker

sheet_laid(Head, Makers, Reply, Octets) :-
    request_options(Head, Words),
    (   get_dict(pens, Head, Wanted)
    ->  (   memberchk(Wanted, [true,false])
        ->  true
        ;   request_error(bad_key(pens, boolean))
        )
    ;   Wanted = false
    ),
    Makers = makers(_,Sheet,_),
    document_world(World),
    document_file(File),
    made_once(World, made(sheet, Words),
              objects_heard(in_state(World, loaded,
                                     call(Sheet, Words, File, Drawing0,
                                          Pens0)),
                            Objects0),
              sheet(Drawing0,Pens0,Objects0)),
    made_once(World, made(sheet, Words), true, sheet(Drawing,Pens,Objects)),
    (   Wanted == true
    ->  pens_body(Drawing, Pens, Reply0, Octets)
    ;   drawing_body(Drawing, Reply0, Octets)
    ),
    Reply = Reply0.put(messages, Objects).

pens_body(drawing(sheet(Width,Height,_), _), Pens, Reply, Octets) :-
    findall(Stroke, ( member(pen(_,_,Strokes), Pens),
                      member(Stroke, Strokes) ),
            All),
    findall(_{pen:Pen, colour:[R,G,B], strokes:N},
            ( member(pen(Pen,rgb(R,G,B),Strokes), Pens),
              length(Strokes, N) ),
            Listed),
    strokes_body(All, Looks, Count, Octets),
    Reply = _{ kind:"strokes", sheet:[Width,Height], looks:Looks,
               strokes:Count, pens:Listed }.

%!  shaded(+Head:dict, +Makers, -Reply:dict, -Octets) is det.
%
%   A picture in PNG.
%
%   @error as sheet_laid/4

shaded(Head, Makers, Reply, Octets) :-
    request_options(Head, Words),
    Makers = makers(_,_,Shaded),
    document_world(World),
    get_time(T0),
    objects_heard(in_state(World, loaded, call(Shaded, Words, Octets)),
                  Objects),
    get_time(T1),
    Ms is (T1-T0)*1000,
    Reply = _{kind:"png", messages:Objects, ms:Ms}.

%!  unfolded(+Head:dict, +Makers, -Reply:dict, -Octets) is det.
%
%   The patterns as strokes, one sheet of them, behind the halves.
%
%   @error as sheet_laid/4

unfolded(Head, Makers, Reply, Octets) :-
    sheet_wanted(Head, Sheet),
    patterns(Makers, Head, unfold(Sheet),
             sg_laid_out:pattern_sheet(Sheet, Reply0, Octets0),
             Reply0-Octets0, Reply1-Octets, Objects),
    Reply = Reply1.put(messages, Objects).

sheet_wanted(Head, Sheet) :-
    (   get_dict(sheet, Head, Sheet)
    ->  (   integer(Sheet),
            Sheet > 0
        ->  true
        ;   request_error(bad_key(sheet, sheet(1)))
        )
    ;   Sheet = 1
    ).

:- public pattern_sheet/5, fold_octets/4.

pattern_sheet(Sheet, Reply, Octets, Ds, Options) :-
    pattern_drawing(Ds, Options, Drawings),
    length(Drawings, Sheets),
    (   nth1(Sheet, Drawings, Drawing)
    ->  true
    ;   request_error(bad_key(sheet, sheet(Sheets)))
    ),
    drawing_body(Drawing, Reply0, Strokes),
    pattern_titles(Ds, Patterns, Halves),
    string_concat(Halves, Strokes, Octets),
    Reply = Reply0.put(_{sheets:Sheets, patterns:Patterns}).

%   pattern_titles(Ds, Patterns, Octets): Octets are pairs of numbers, as many
%   of each pattern as its `halves` says.

pattern_titles(Ds, Patterns, Octets) :-
    maplist(pattern_title, Ds, Patterns, Numbers0),
    append(Numbers0, Numbers),
    foldl(int32_codes, Numbers, Codes, []),
    string_codes(Octets, Codes).

int32_codes(N, [A,B,C,D|Codes], Codes) :-
    A is N /\ 255,
    B is N>>8 /\ 255,
    C is N>>16 /\ 255,
    D is N>>24 /\ 255.

%   Only development(S) has the edges of a segment S of the model.

pattern_title(D, Pattern, Numbers) :-
    segment(D, _, Term),
    format(string(Title), "~W", [Term, [quoted(true), max_depth(12)]]),
    pattern_of(D, T),
    part_named(T, S),
    (   Term == development(S)
    ->  Edges = true,
        findall([E,Half], other_half(D, S, E, Half), Halves)
    ;   Edges = false,
        Halves = []
    ),
    length(Halves, N),
    append(Halves, Numbers),
    Pattern = _{pattern:D, of:Title, segment:S, edges:Edges, halves:N}.

%   other_half(D, S, E, Half) is nondet: the pattern D has an edge E of S, which
%   pictures call by the number of the other half of it.

other_half(D, S, E, Half) :-
    e(D, E, _, _, _),
    e(S, E, V1, V2, _),
    findall(Back, e(S, Back, V2, V1, _), Backs),
    min_list(Backs, Half),
    Half < E.

%!  folded(+Head:dict, +Makers, -Reply:dict, -Octets) is det.
%
%   What can be folded, as FOLD, behind the halves.
%
%   @error as sheet_laid/4

folded(Head, Makers,
       _{kind:"fold", patterns:Patterns, messages:Objects}, Octets) :-
    patterns(Makers, Head, fold, sg_laid_out:fold_octets(Titles0, Octets0),
             Titles0-Octets0, Patterns-Octets, Objects).

fold_octets(Patterns, Octets, Ds, Options) :-
    captured(copied_to(-, fold, sg_laid_out:fold_written(Ds, Options)), File),
    pattern_titles(Ds, Patterns, Halves),
    string_concat(Halves, File, Octets).

:- public fold_written/3.

fold_written(Ds, Options, File) :-
    write_fold(File, Ds, Options).

%   patterns(Makers, Head, What, Goal, Made, Value, Objects): Value is what
%   Made becomes by call(Goal, Ds, Options), of the patterns that Head asks
%   for; Objects are the messages. It is done once a revision.

:- meta_predicate patterns(+, +, +, 2, ?, -, -).

patterns(Makers, Head, What, Goal, Made, Value, Objects) :-
    request_options(Head, Words0),
    (   get_dict(segment, Head, S)
    ->  (   integer(S),
            S > 0
        ->  number_string(S, Only),
            append(["--only",Only], Words0, Words)
        ;   request_error(bad_key(segment, segment))
        )
    ;   Words = Words0
    ),
    Makers = makers(Patterns,_,_),
    document_world(World),
    made_once(World, made(What, Words),
              objects_heard(in_state(World, loaded,
                                     ( call(Patterns, Words, Ds, Options),
                                       call(Goal, Ds, Options) )),
                            Objects0),
              Made-Objects0),
    made_once(World, made(What, Words), true, Value-Objects).
