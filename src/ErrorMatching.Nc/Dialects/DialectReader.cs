using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Applies one file to the tables of a dialect, and collects errors that a schema cannot express: invalid codes, and codes
/// stated twice.</summary>
internal sealed class DialectReader(DialectDocument document, DialectTables tables)
{
    private static readonly Dictionary<string, int> Meanings = KebabNames.Of(typeof(NcMeaning));
    private static readonly Dictionary<string, int> Roles = KebabNames.Of(typeof(LetterRole));
    private static readonly Dictionary<string, int> FunctionRoles = KebabNames.Of(typeof(FunctionRole));
    private static readonly Dictionary<string, int> Writings = KebabNames.Of(typeof(OffsetWriting));
    private static readonly Dictionary<string, int> Syntaxes = KebabNames.Of(typeof(NcSyntax));
    private static readonly Dictionary<string, int> Switches = KebabNames.Of(typeof(BlockSkip));
    private static readonly Dictionary<string, int> Namings = KebabNames.Of(typeof(ProgramNaming));
    private static readonly Dictionary<string, int> Comments = KebabNames.Of(typeof(NestedComments));
    private static readonly Dictionary<string, int> Starts = KebabNames.Of(typeof(CompensationStart));
    private static readonly Dictionary<string, int> CornerNames = KebabNames.Of(typeof(CompensationCorner));

    // What only languages have, and all else that can be followed in one.
    private static readonly NcMeaning[] MeaningsOfLanguages =
    [
        NcMeaning.RapidInBlock, NcMeaning.ArcByRadius, NcMeaning.ArcAboutPole, NcMeaning.PolarArc, NcMeaning.PolarLine,
        NcMeaning.PolarTangentArc, NcMeaning.ArcSense, NcMeaning.SetPole, NcMeaning.CornerRounding, NcMeaning.CornerChamfer,
        NcMeaning.DatumShift, NcMeaning.UnknownOrigin, NcMeaning.ToolAxisRetract, NcMeaning.Approach, NcMeaning.Departure,
        NcMeaning.ComputedContour, NcMeaning.ApproachTangent, NcMeaning.ApproachNormal, NcMeaning.DepartureTangent,
        NcMeaning.DepartureNormal, NcMeaning.ToolCall, NcMeaning.ToolDefinition,
    ];

    private static readonly NcMeaning[] MeaningsWithWords =
    [
        NcMeaning.Line, NcMeaning.TangentArc, NcMeaning.ArcByRadius, NcMeaning.ArcAboutPole, NcMeaning.PolarArc, NcMeaning.PolarLine,
        NcMeaning.PolarTangentArc, NcMeaning.SetPole, NcMeaning.CornerRounding, NcMeaning.CornerChamfer, NcMeaning.DatumShift,
        NcMeaning.Approach, NcMeaning.Departure, NcMeaning.ApproachTangent, NcMeaning.ApproachNormal, NcMeaning.DepartureTangent,
        NcMeaning.DepartureNormal,
    ];

    private static readonly NcMeaning[] CommonMeanings =
    [
        NcMeaning.Unknown, NcMeaning.Harmless, NcMeaning.Line, NcMeaning.TangentArc, NcMeaning.PlaneXY, NcMeaning.PlaneZX,
        NcMeaning.PlaneYZ, NcMeaning.Inch, NcMeaning.Metric, NcMeaning.CompensationOff, NcMeaning.CompensationLeft,
        NcMeaning.CompensationRight, NcMeaning.MachineCoordinates, NcMeaning.OpaqueTransform, NcMeaning.OpaqueTransformOff,
        NcMeaning.Smoothing, NcMeaning.OpaqueCall, NcMeaning.CycleCall, NcMeaning.CompensationSharpCorner,
        NcMeaning.CompensationUnfollowed, NcMeaning.MeasuringCycle,
    ];

    public List<Refusal> Problems { get; } = [];

    public void Apply()
    {
        foreach (var member in document.Root.Find("settings")?.Members ?? [])
        {
            Set(member.Name, member.Value["value"]);
        }

        foreach (var (key, subjects, topic) in DialectDocument.Lists)
        {
            Apply(topic, document.List(key), subjects);
        }

        Refuse(document.List("refusals"));
    }

    // An entry replaces one of the same name of an earlier file.
    private void Refuse(IReadOnlyList<JsonItem> entries)
    {
        var stated = new HashSet<string>(StringComparer.Ordinal);
        var subjects = new List<SubjectRange>();
        foreach (var entry in entries)
        {
            var name = entry["name"].Text;
            if (!stated.Add(name))
            {
                Problems.Add(JsonRefusal.At(entry["name"], "stated-twice", $"{name} again", "each once in a file"));
            }

            foreach (var key in RefusalTable.SetsOfCodes)
            {
                foreach (var word in entry.Find(key)?.Text.Split([' ', '&'], StringSplitOptions.RemoveEmptyEntries) ?? [])
                {
                    if (!SubjectRange.TryRead(word, word[0] == 'M' ? DialectTopic.Function : DialectTopic.Code, subjects, out _)
                        || !subjects[^1].HasNumbers)
                    {
                        Problems.Add(JsonRefusal.At(entry[key], "bad-subject", $"\"{word}\"", "G codes and M functions, with spaces "
                            + "between them"));
                    }
                }
            }

            var known = tables.Refusals.FindIndex(r => r["name"].Text == name);
            if (known >= 0)
            {
                tables.Refusals.RemoveAt(known);
            }

            tables.Refusals.Add(entry);
        }

        if (entries.Count > 0 && Problems.Count == 0 && new RefusalTable(tables.Refusals).HasTooMany)
        {
            Problems.Add(JsonRefusal.At(document.Root["refusals"], "too-many-items", "more codes that the refusals distinguish than can be",
                "fewer"));
        }
    }

    private void Set(string name, JsonItem value)
    {
        switch (name)
        {
            case "syntax": tables.Syntax = (NcSyntax)Syntaxes[value.Text]; break;
            case "integersAreIncrements": tables.IntegersAreIncrements = value.Flag; break;
            case "notesNumbersWithoutPoint": tables.NotesNumbersWithoutPoint = value.Flag; break;
            case "semicolonEndsBlock": tables.SemicolonEndsBlock = value.Flag; break;
            case "blockSkip": tables.BlockSkip = (BlockSkip)Switches[value.Text]; break;
            case "metricDecimals": tables.MetricDecimals = (int)value.Number; break;
            case "inchDecimals": tables.InchDecimals = (int)value.Number; break;
            case "arcMismatchMm": tables.ArcMismatchMm = value.Number; break;
            case "arcMismatchOfRadius": tables.ArcMismatchOfRadius = value.Number; break;
            case "peckLetters": tables.PeckLetters = value.Text.Aggregate(0u, (bits, letter) => bits | (1u << (letter - 'A'))); break;
            case "sequenceLetter": tables.SequenceLetter = LetterOf(value); break;
            case "repeatsInNumber": tables.RepeatsInNumber = value.Flag; break;
            case "workOffsetLetter": tables.WorkOffsetLetter = LetterOf(value); break;
            case "firstWorkOffset": SetFirstWorkOffset(value); break;
            case "systemLines": tables.SystemLines = value.Flag; break;
            case "macros": tables.HasMacros = value.Flag; break;
            case "commentCapitals": tables.CommentCapitals = value.Flag; break;
            case "commentLength": tables.CommentLength = (int)value.Number; break;
            case "turnsLetter": tables.TurnsLetter = LetterOf(value); break;
            case "programNames": tables.ProgramNaming = (ProgramNaming)Namings[value.Text]; break;
            case "longestLine": tables.LongestLine = (int)value.Number; break;
            case "nestedComments": tables.NestedComments = (NestedComments)Comments[value.Text]; break;
            case "workOffsets": SetWorkOffsets(value); break;
            case "offsetProgram": tables.Offsets.Program = LinesOf(value, OffsetRule.InProgram, []); break;
            case "offsetCall": tables.Offsets.Call = LineOf(value, OffsetRule.InCall, []); break;
            case "offsetFile": tables.Offsets.File = LineOf(value, OffsetRule.InFile, []); break;
            case "radiusOffset": tables.Offsets.Radius = LinesOf(value, OffsetRule.InRadius, OffsetRule.BeforeRadius); break;
            case "workOffset": tables.Offsets.Work = LinesOf(value, OffsetRule.InWork, OffsetRule.BeforeWork); break;
            default: SetCompensation(tables.Compensation, name, value); break;
        }
    }

    private void SetCompensation(CompensationRule rule, string name, JsonItem value)
    {
        switch (name)
        {
            case "compensationStart": rule.Start = (CompensationStart)Starts[value.Text]; break;
            case "compensationStartExceedsRadius": rule.StartExceedsRadius = value.Flag; break;
            case "compensationArcsExceedRadius": rule.ArcsExceedRadius = value.Flag; break;
            case "compensationStartsOnArcs": rule.StartsOnArcs = value.Flag; break;
            case "compensationEndsInPlane": rule.EndsInPlane = value.Flag; break;
            case "compensationEndsAtCalls": rule.EndsAtCalls = value.Flag; break;
            case "compensationWorksInYz": rule.WorksInYz = value.Flag; break;
            case "compensationCorners": rule.OutsideCorners = (CompensationCorner)CornerNames[value.Text]; break;
            case "compensationSharpCorners": rule.SharpCorners = (CompensationCorner)CornerNames[value.Text]; break;
            case "compensationSharpDegrees": rule.SharpDegrees = value.Number; break;
            case "compensationStraightDegrees": rule.StraightDegrees = value.Number; break;
            case "compensationArcGrowthRadians": rule.ArcGrowthRadians = value.Number; break;
            case "compensationStops": SetStops(rule, value); break;
        }
    }

    private void SetStops(CompensationRule rule, JsonItem value)
    {
        rule.StopCodes.Clear();
        rule.StopFunctions.Clear();
        foreach (var word in value.Text.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        {
            var (topic, stops) = word[0] == 'M' ? (DialectTopic.Function, rule.StopFunctions) : (DialectTopic.Code, rule.StopCodes);
            var subjects = new List<SubjectRange>();
            if (!SubjectRange.TryRead(word, topic, subjects, out var bad) || subjects.Exists(s => !s.HasNumbers))
            {
                Problems.Add(JsonRefusal.At(value, "bad-subject", $"\"{bad}\"", "G codes and M functions, with spaces between them"));
                continue;
            }

            foreach (var subject in subjects)
            {
                for (var number = subject.First; number <= subject.Last; number += subject.Step)
                {
                    stops.Add(number);
                }
            }
        }
    }

    private void SetWorkOffsets(JsonItem value)
    {
        var subjects = new List<SubjectRange>();
        if (!SubjectRange.TryRead(value.Text, DialectTopic.Code, subjects, out var bad))
        {
            Problems.Add(JsonRefusal.At(value, "bad-subject", $"\"{bad}\"", "G codes with spaces between them"));
        }

        tables.Offsets.Codes = [.. subjects.Select(s => s.First)];
    }

    private void SetFirstWorkOffset(JsonItem value)
    {
        if (OffsetNames.Read(value.Text, tables.WorkOffsetLetter) is { Codes: [var code], First: 0 })
        {
            tables.FirstWorkOffset = code;
            return;
        }

        Problems.Add(JsonRefusal.At(value, "bad-subject", $"\"{value.Text}\"", "a G code that chooses a work offset"));
    }

    private OffsetTable? OffsetTableOf(JsonItem entry)
    {
        var names = new List<OffsetNames>();
        foreach (var text in entry.Find("offsets")?.Text.Split('|', StringSplitOptions.TrimEntries) ?? [])
        {
            if (OffsetNames.Read(text, tables.WorkOffsetLetter) is not { } read)
            {
                Problems.Add(JsonRefusal.At(entry["offsets"], "bad-subject", $"\"{text}\"",
                    "G codes such as G54..G59, or a code with numbers such as G54.1 P1..P48; other names of the same offsets behind a |"));
                return null;
            }

            names.Add(read);
        }

        return new((OffsetWriting)Writings[entry["means"].Text], names, entry.Find("zeroIsActive") is { Flag: true },
            entry["source"].Text.StartsWith("assumed", StringComparison.Ordinal));
    }

    // Lines with names in braces. Names of the correction before are for lines with a question mark only.
    private IReadOnlyList<string> LinesOf(JsonItem value, IReadOnlyList<string> names, IReadOnlyList<string> before) =>
        [.. value.Items.Select(line => LineOf(line, names, before))];

    private string LineOf(JsonItem line, IReadOnlyList<string> names, IReadOnlyList<string> before)
    {
        string[] known = line.Text.StartsWith('?') ? [.. names, .. before] : [.. names];
        foreach (var name in OffsetRule.NamesIn(line.Text).Where(n => !known.Contains(n, StringComparer.Ordinal)))
        {
            Problems.Add(JsonRefusal.At(line, "unknown-value", $"{{{name}}}",
                $"one of {string.Join(", ", known.Select(k => $"{{{k}}}"))}"));
        }

        return line.Text;
    }

    private static byte LetterOf(JsonItem value) => value.Text.Length == 0 ? (byte)0 : (byte)value.Text[0];

    // Ranges first: a single code has priority over a range, regardless of their order.
    private void Apply(DialectTopic topic, IReadOnlyList<JsonItem> entries, string key)
    {
        var singles = new List<DialectStatement>();
        var stated = new HashSet<string>(KeywordComparer.Instance);
        var subjects = new List<SubjectRange>();
        foreach (var entry in entries)
        {
            subjects.Clear();
            if (!SubjectRange.TryRead(entry[key].Text, topic, subjects, out var bad))
            {
                Problems.Add(JsonRefusal.At(entry[key], "bad-subject", $"\"{bad}\"", Expected(topic)));
                continue;
            }

            foreach (var subject in subjects)
            {
                if (subject.IsRange)
                {
                    Apply(topic, entry, subject);
                }
                else if (stated.Add(subject.Names().First()))
                {
                    singles.Add(new(entry, subject));
                }
                else
                {
                    Problems.Add(JsonRefusal.At(entry[key], "stated-twice", $"{subject.Spelling} again", "each once in a file"));
                }
            }
        }

        foreach (var single in singles)
        {
            Apply(topic, single.Entry, single.Subject);
        }
    }

    private void Apply(DialectTopic topic, JsonItem entry, SubjectRange subject)
    {
        switch (topic)
        {
            case DialectTopic.Code when Misplaced((NcMeaning)Meanings[entry["means"].Text], subject) is { } expected:
                Problems.Add(JsonRefusal.At(entry["means"], "bad-role", $"\"{entry["means"].Text}\" for {subject.Spelling}", expected));
                break;
            case DialectTopic.Code when subject.Word.Length == 1 && !subject.HasNumbers && LanguageSpelling.HasCodesIn(tables.Syntax):
                Problems.Add(JsonRefusal.At(entry["codes"], "bad-subject", $"\"{subject.Spelling}\"", Expected(topic)));
                break;
            case DialectTopic.Function
                when !subject.IsRange && LanguageSpelling.Of(tables.Syntax)?.IsKeyword(subject.First) == true:
                Problems.Add(JsonRefusal.At(
                    entry["functions"], "bad-subject", $"\"{subject.Spelling}\"", "it among the codes: it is the control's own"));
                break;
            case DialectTopic.Letter
                when subject.Word.Length == 1 && Misplaced((LetterRole)Roles[entry["role"].Text], subject.Word[0]) is { } expected:
                Problems.Add(JsonRefusal.At(entry["role"], "bad-role", $"\"{entry["role"].Text}\" for {subject.Spelling}", expected));
                break;
            case DialectTopic.Code:
                Code(
                    subject,
                    (NcMeaning)Meanings[entry["means"].Text],
                    tables.FamilyNumber(entry.Find("family")?.Text ?? ""),
                    entry.Find("feeds") is { Flag: false });
                break;
            case DialectTopic.Letter when subject.Word.Length == 1:
                tables.RoleOf[subject.Word[0] - 'A'] = (LetterRole)Roles[entry["role"].Text];
                break;
            case DialectTopic.Letter:
                foreach (var name in subject.Names())
                {
                    tables.Addresses[name] = Roles[entry["role"].Text];
                }

                break;
            case DialectTopic.Function:
                Array.Fill(
                    tables.FunctionOf, (FunctionRole)FunctionRoles[entry["role"].Text], subject.First, subject.Last - subject.First + 1);
                break;
            case DialectTopic.Flow:
                tables.Flow.UnionWith(subject.Names());
                break;
            case DialectTopic.OffsetTable when OffsetTableOf(entry) is { } table:
                for (var number = subject.First; number <= subject.Last; number++)
                {
                    tables.OffsetTables[number] = table;
                }

                break;
            case DialectTopic.OffsetTable:
                break;
            case DialectTopic.MachineProgram when subject is { HasNumbers: true, Word: "" }:
                tables.MachineNumbers.Add(subject);
                break;
            default:
                tables.MachineNames.UnionWith(subject.Names());
                break;
        }
    }

    // Rejects a role that the interpreter cannot apply to the subject.
    private string? Misplaced(NcMeaning meaning, SubjectRange subject)
    {
        var isCode = subject is { HasNumbers: true, Word: "G" };
        if (Array.IndexOf(CommonMeanings, meaning) < 0
            && Array.IndexOf(MeaningsOfLanguages, meaning) >= 0 == LanguageSpelling.HasCodesIn(tables.Syntax))
        {
            return "another meaning: programs in this syntax cannot have this one";
        }

        return meaning switch
        {
            _ when Array.IndexOf(MeaningsWithWords, meaning) >= 0 && LanguageSpelling.Of(tables.Syntax) is { } language
                && !language.HasWords(Encoding.ASCII.GetBytes(subject.Word)) => "another meaning: no coordinates can follow this word",
            NcMeaning.ToolCall or NcMeaning.ToolDefinition
                when LanguageSpelling.Of(tables.Syntax)?.NamesTool(Encoding.ASCII.GetBytes(subject.Word)) == false =>
                "another meaning: no tool can follow this word",
            _ when isCode && !LanguageSpelling.HasCodesIn(tables.Syntax) => "a word: programs in this syntax have no codes",
            NcMeaning.CycleCall or NcMeaning.ModalCycle or NcMeaning.MeasuringCycle when isCode =>
                "another meaning: only a word of several letters can have this one",
            NcMeaning.WorkOffset or NcMeaning.ReferenceReturn or NcMeaning.StoreReference when !isCode =>
                "another meaning: only a G code can have this one",
            _ => null,
        };
    }

    private string? Misplaced(LetterRole role, char letter)
    {
        LetterRole[] fitting = letter switch
        {
            'X' or 'Y' or 'Z' => [LetterRole.Axis],
            'I' or 'J' or 'K' => [LetterRole.Center],
            'F' => [LetterRole.Feed],
            'G' => [LetterRole.G],
            'M' => [LetterRole.M],
            'N' => [LetterRole.Number],
            'O' => [LetterRole.Program],
            'R' => [LetterRole.Radius, LetterRole.Variable],
            'T' when !LanguageSpelling.HasCodesIn(tables.Syntax) => [LetterRole.ToolCall],
            'L' when tables.Syntax == NcSyntax.Siemens => [LetterRole.Program],
            'D' or 'H' or 'T' =>
                [LetterRole.Harmless, LetterRole.OtherAxis, LetterRole.Variable, LetterRole.Length, LetterRole.LengthNumber],
            _ => [LetterRole.Harmless, LetterRole.OtherAxis, LetterRole.Variable],
        };
        return role == LetterRole.Unknown || Array.IndexOf(fitting, role) >= 0
            ? null
            : $"{string.Join(" or ", NamesOf(fitting))}, or unknown: the letter can have no other role";
    }

    private static IEnumerable<string> NamesOf(LetterRole[] roles) =>
        Roles.Where(r => Array.IndexOf(roles, (LetterRole)r.Value) >= 0).Select(r => r.Key);

    private void Code(SubjectRange subject, NcMeaning meaning, int family, bool lengthsOnly)
    {
        if (subject is { HasNumbers: true, Word: "G" })
        {
            for (var tenths = subject.First; tenths <= subject.Last; tenths += subject.Step)
            {
                tables.MeaningOf[tenths] = meaning;
                tables.FamilyOf[tenths] = family;
                tables.IsForLengthsOnly[tenths] = lengthsOnly;
            }

            return;
        }

        foreach (var name in subject.Names())
        {
            tables.SetWord(name, meaning, family);
        }
    }

    private static string Expected(DialectTopic topic) => topic switch
    {
        DialectTopic.Code => "G codes up to G999.9, ranges such as G54..G59, or words in capitals, with spaces between them",
        DialectTopic.Letter => "capital letters, or longer addresses such as CR, with spaces between them",
        DialectTopic.Function => "functions such as M98, or ranges such as M100..M199, with spaces between them",
        DialectTopic.OffsetTable => "L words such as L2, or ranges such as L10..L13, with spaces between them",
        DialectTopic.Flow => "words in capitals, with spaces between them",
        _ => "program numbers such as 9810 or 9810..9819, or names in capitals, with spaces between them",
    };
}
