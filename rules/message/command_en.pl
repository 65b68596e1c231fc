:- module(sg_command_en,
          [ command_en//1               % +What
          ]).
:- use_module(batch_en, [batch_usage_en//1]).
:- use_module(message_parts, [meant_en//1, syntax_words//1]).
:- use_module(model_en, [limit_en//1, model_en//1]).
:- use_module(parameter_en, [parameter_en//1]).
:- use_module(pattern_en, [pattern_fault_en//1]).
:- use_module(sheet_en, [sheet_en//1]).
:- use_module(unfold_en, [wish_en//3, unfold_en//1]).
/** <module> What is wrong with a command line, in English.

command_ko.pl has the same heads in Korean.
*/

%!  command_en(+What)// is semidet.
%
%   The message for usage_error(What).

command_en(no_verb) -->
    [ 'what should be done?', nl, '  Try sanggwan --help.' ].
command_en(unknown_verb(Verb, Near)) -->
    [ 'there is no verb ~w'-[Verb] ],
    meant_en(Near),
    [ nl, '  Try sanggwan --help.' ].
command_en(unknown_option(Text, Near)) -->
    [ 'unknown option ~w'-[Text] ],
    meant_en(Near),
    [ nl, '  sanggwan VERB --help lists those of a verb.' ].
command_en(no_value(Text)) -->
    [ 'option ~w takes no value'-[Text] ].
command_en(needs_value(Text, What)) -->
    [ 'option ~w needs a value: ~w'-[Text, What], nl,
      '  sanggwan VERB --help says what it may be.' ].
command_en(option_twice(Text)) -->
    [ 'option ~w is given twice'-[Text] ].
command_en(bad_value(Text, Value, one_of(Words))) -->
    { atomic_list_concat(Words, ', ', All) },
    [ 'option ~w: ~w is none of ~w'-[Text, Value, All] ].
command_en(bad_value(Text, Value, number(Low))) -->
    [ 'option ~w: ~w is no number from ~w on'-[Text, Value, Low] ].
command_en(bad_value(Text, Value, number(Low, High))) -->
    [ 'option ~w: ~w is no number from ~w to ~w'-[Text, Value, Low, High] ].
command_en(bad_value(Text, Value, above(Low))) -->
    [ 'option ~w: ~w is no number above ~w'-[Text, Value, Low] ].
command_en(bad_value(Text, Value, whole(Low, High))) -->
    [ 'option ~w: ~w is no whole number from ~w to ~w'-
      [Text, Value, Low, High] ].
command_en(no_clear_dots(Format)) -->
    [ 'a .~w has no clear dots'-[Format], nl,
      '  Give --background a colour, or write a .png.' ].
command_en(shade_in_dots(Format)) -->
    [ 'a .~w has lines alone, and this shading is in dots'-[Format], nl,
      '  Give --shade hatch for strokes of the pen.' ].
command_en(no_size(Text, Value)) -->
    [ 'option ~w: ~w is no size: width and height must be above 0'-
      [Text, Value] ].
command_en(bad_value(Text, Value, no_normal)) -->
    !,
    [ 'option ~w: ~w is no plane'-[Text, Value], nl,
      '  A,B,C,D is the plane A*X + B*Y + C*Z + D = 0, with A, B or C other \c
       than 0.' ].
command_en(bad_value(Text, Value, Form)) -->
    { atom(Form) },
    [ 'option ~w: ~w should look like ~w'-[Text, Value, Form] ].
command_en(one_model(Verb, File)) -->
    [ '~w shows one model; ~p is one more'-[Verb, File] ].
command_en(port_taken(Port)) -->
    [ 'another program listens at port ~w'-[Port], nl,
      '  Give another --port, or none.' ].
command_en(port_refused(Port)) -->
    [ 'this user may not listen at port ~w'-[Port], nl,
      '  Give a --port from 1024 on.' ].
command_en(host_needs_class(Host)) -->
    [ '--host ~w lets others in, and they would all change one \c
       model'-[Host], nl,
      '  Add --class: each who joins has the model for himself. Or leave \c
       --host out, and reach this machine by a tunnel (ssh -L).' ].
command_en(behind(URL)) -->
    [ '--behind ~w is no address of a page'-[URL], nl,
      '  Write it as people see it, like https://h.example/sanggwan/.' ].
command_en(socket_alone(Path)) -->
    [ '--socket ~w is for a proxy'-[Path], nl,
      '  Add --behind URL, where people see the page, and leave --port and \c
       --host out.' ].
command_en(socket_taken(Path)) -->
    [ 'another program listens at ~w'-[Path], nl,
      '  Give another --socket, or end that program.' ].
command_en(no_socket(Path)) -->
    [ 'no socket can be made at ~w'-[Path], nl,
      '  Its folder must be there and be writable, and nothing else have this \c
       name, which is at most 107 octets long.' ].
command_en(socket_passed('')) -->
    [ 'what was passed (LISTEN_FDS) is not one Unix socket that listens', nl,
      '  A unit of systemd has one ListenStream=, a path, and Accept=no.' ].
command_en(socket_passed(Path)) -->
    [ 'a socket was passed that listens at ~w'-[Path], nl,
      '  Say --socket ~w, and --behind.'-[Path] ].
command_en(embed(URL)) -->
    [ '--embed ~w is no origin of pages'-[URL], nl,
      '  Write it without a path, like https://h.example.' ].
command_en(no_address(Host)) -->
    [ 'this machine has no address ~p to listen at'-[Host], nl,
      '  Leave --host out: only this machine can reach it then.' ].
command_en(no_files_taken(Verb, File)) -->
    [ '~w takes no files: ~p'-[Verb, File] ].
command_en(no_files(What)) -->
    [ '~w is missing'-[What], nl,
      '  sanggwan VERB --help says what belongs there.' ].
command_en(unfold(S, Wish, What)) -->
    wish_en(S, Wish, What).
command_en(unfold(What)) -->
    unfold_en(What).
command_en(one_operand(Verb)) -->
    [ '~w needs two models or more'-[Verb], nl,
      '  Name the other ones too; each file is one operand.' ].
command_en(both_options(A, B)) -->
    [ 'options ~w and ~w do not go together'-[A, B] ].
command_en(needs_one_of(Options)) -->
    { atomic_list_concat(Options, ' or ', Text) },
    [ 'option ~w is missing'-[Text] ].
command_en(no_output) -->
    [ 'where should the result go? Give -o FILE (- is standard output)' ].
command_en(replaces_model(File)) -->
    [ '~w is the model; its picture would take its place'-[File], nl,
      '  Give the picture another name.' ].
command_en(ending(File, Endings)) -->
    { atomic_list_concat(Endings, ' .', All) },
    [ '~w: the ending decides the format; it can be .~w'-[File, All] ].
command_en(no_folder(Folder)) -->
    [ 'there is no folder ~w for the result'-[Folder], nl,
      '  Make it first.' ].
command_en(cannot_write(File, permission)) -->
    [ '~w: the result may not be written there'-[File], nl,
      '  Check the permissions of the file and its folder, or name another.' ].
command_en(cannot_write(output, Why)) -->
    [ 'the result cannot be written: ~w'-[Why], nl,
      '  Make room, or send it elsewhere.' ].
command_en(cannot_write(File, no_folder)) -->
    [ '~w: there is no folder for the result'-[File], nl,
      '  Make it first; of a link it is that of what the link names.' ].
command_en(cannot_write(File, directory)) -->
    [ '~w is a folder; the result is a file'-[File], nl,
      '  Give the result another name.' ].
command_en(cannot_write(File, full)) -->
    [ '~w cannot be written: the disk is full'-[File], nl,
      '  Make room, or send it elsewhere. Nothing was written.' ].
command_en(cannot_write(File, too_large)) -->
    [ '~w cannot be written: the system allows no file so large'-[File], nl,
      '  Raise the limit (ulimit -f), or write less. Nothing was written.' ].
command_en(cannot_write(File, long_name)) -->
    [ '~w: the name is too long for a file'-[File], nl,
      '  Most systems take 255 bytes, and 4,095 with the folders.' ].
command_en(cannot_write(File, links)) -->
    [ '~w is a link that leads back to itself'-[File], nl,
      '  Remove it, or give the result another name.' ].
command_en(cannot_write(File, Why)) -->
    [ '~w cannot be written: ~w'-[File, Why], nl,
      '  Give the result another place.' ].
command_en(large_by_rule) -->
    [ 'pixel_colour/4 is a rule: it is asked of 67108864 dots at most', nl,
      '  Give a smaller --size, or make the picture in parts (--window).' ].
command_en(no_segment(S, Known)) -->
    { atomic_list_concat(Known, ', ', All) },
    [ 'there is no segment ~w, only ~w'-[S, All] ].
command_en(parameter(setting(Text, limit(Name, Most)))) -->
    !,
    [ '--set ~w: '-[Text] ],
    model_en(limit(Name, Most)).
command_en(parameter(What)) -->
    parameter_en(What).
command_en(pattern(What)) -->
    pattern_fault_en(What).
command_en(batch(What)) -->
    batch_usage_en(What).
command_en(each(What)) -->
    each_en(What).
command_en(sheet(What)) -->
    sheet_en(What).
command_en(exact_format(Format)) -->
    [ '--exact is for tables (csv, tsv, txt), not for ~w'-[Format] ].
command_en(bad_goal(_, limit(Name, Most))) -->
    [ 'the text of a goal has more than ~D '-[Most] ],
    limit_en(Name),
    [ nl, '  To allow more: --limits ~w=N, in a program set_limit(~w, N).'-
      [Name, Name] ].
command_en(bad_goal(Text, after_full_stop)) -->
    [ 'there is more after the first full stop: ~w'-[Text], nl,
      '  One goal is asked at a time; put commas between its parts.' ].
command_en(bad_goal(Text, Why)) -->
    { Why \= limit(_, _),
      Why \== after_full_stop
    },
    [ 'this is no goal: ~w ('-[Text] ],
    syntax_words(Why),
    [ ')' ].

%   each_en(What)//: what is wrong with the list of files of --each.

each_en(standard_input) -->
    [ 'standard input (-) is not one of the files of --each: it has no name',
      nl,
      '  Leave --each out, or name a file.' ].
each_en(no_place(Option, Text)) -->
    [ '~w ~w: with --each the name needs a % for the name of the file'-
      [Option, Text], nl,
      '  For example \'%.svg\', or \'plans/%.pdf\'.' ].
each_en(same_output(Output, File, File)) -->
    !,
    [ '~w is named twice, and would be written to ~w twice'-[File, Output], nl,
      '  Name each file once.' ].
each_en(same_output(Output, File1, File2)) -->
    [ '~w would hold the result of both ~w and ~w'-[Output, File1, File2], nl,
      '  Do files of the same name in commands of their own.' ].
each_en(model_output(Output)) -->
    [ '~w is one of the files; the result of another would take its place'-
      [Output], nl,
      '  Give the results another folder: -o \'FOLDER/%.pl\'.' ].
each_en(json_alone) -->
    [ '--json needs --each here: it is a line for each file' ].
each_en(rules_remain(File)) -->
    [ 'the rules did to the program, at ~w, what cannot be taken back'-[File],
      nl,
      '  The files after it are not done. Do each in a command of its own.' ].
