using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>The parts of a file: its programs and the statements of each structure. Created once, at the first flow statement.</summary>
internal sealed class FlowIndex
{
    private readonly NcSyntax _syntax;
    private readonly List<FlowUnit> _units = [];
    private readonly Dictionary<string, int> _numbers = new(StringComparer.Ordinal);
    private readonly Dictionary<string, FlowUnit> _named = new(StringComparer.Ordinal);
    private readonly FlowStatements _statements;
    private readonly TargetSearch _search;

    public FlowIndex(NcProgram program, NcDialect dialect)
    {
        var syntax = dialect.Syntax;
        Program = program;
        _syntax = syntax;
        _statements = new(syntax);
        var skips = dialect.BlockSkip == BlockSkip.On;
        _search = new(program, syntax, skips);
        var (name, first, hasContent) = ("", Leader.BlocksOf(program, dialect), false);
        var end = program.BlockCount;
        for (var i = first; i < end; i++)
        {
            var text = program.BytesOf(program[i]);
            var head = BlockHead.Read(text, syntax);
            if (skips && head.IsSkip)
            {
                continue;
            }

            if (HeadingOf(text, head.At, syntax) is { } heading)
            {
                // LinuxCNC continues past the number of a subprogram; only the second percent sign ends the file.
                if (syntax == NcSyntax.LinuxCnc)
                {
                    end = heading.Length == 0 && hasContent ? i : end;
                    hasContent = true;
                    if (heading.Length > 0)
                    {
                        _numbers.TryAdd(heading, i);
                    }

                    continue;
                }

                if (hasContent)
                {
                    AddUnit(name, first, i);
                    (first, name) = (i, "");
                }

                (name, hasContent) = (heading.Length == 0 ? name : heading, heading.Length > 0);
            }
            else if (head.At < text.Length && text[head.At] != ';')
            {
                hasContent = true;
                _statements.Add(text, head.At, i);
            }
        }

        AddUnit(name, first, end);
        foreach (var (number, begin) in _numbers)
        {
            _named.TryAdd(number, new(this, number, begin, end));
        }

        Main = _units.Find(u => u.Name.EndsWith(MainEnding, StringComparison.Ordinal)) ?? _units[0];
    }

    private const string MainEnding = "_MPF";

    public NcProgram Program { get; }

    /// <summary>The program that runs first: the first main program of an archive, or else the first of the file.</summary>
    public FlowUnit Main { get; }

    /// <summary>The program with a name; null if the file has none.</summary>
    public FlowUnit? Unit(string name) => _named.GetValueOrDefault(name);

    /// <summary>The program that contains a block.</summary>
    public FlowUnit UnitAt(int block)
    {
        var (low, high) = (0, _units.Count - 1);
        while (low < high)
        {
            var middle = (low + high) / 2;
            (low, high) = block < _units[middle].End ? (low, middle) : (middle + 1, high);
        }

        return _units[low];
    }

    /// <summary>The work of searching for jump targets so far, in blocks with heads of usual length.</summary>
    public long Searched => _search.Count;

    /// <summary>The structure statement at a block; null if there is none.</summary>
    public FlowStatement? StatementAt(int block) => _statements.At(block);

    /// <summary>The definition of a LinuxCNC subroutine; null if the file has none.</summary>
    public FlowStatement? Sub(string label) => _statements.Sub(label);

    /// <summary>The block with a number, searched forward from a block and then from the start of the program; -1 if none.</summary>
    public int FindNumber(FlowUnit unit, int from, long number, bool forward = true, bool backward = true) =>
        _search.Number(unit, from, number, forward, backward);

    /// <summary>The block with a label, searched as for a number.</summary>
    public int FindLabel(FlowUnit unit, int from, string label, bool forward = true, bool backward = true) =>
        _search.Label(unit, from, label, forward, backward);

    /// <summary>The name for a program number: <c>O0100</c>.</summary>
    public static string NumberName(long number) => string.Create(CultureInfo.InvariantCulture, $"O{number:D4}");

    /// <summary>A Siemens name without file and archive marks: <c>_N_POCKET_SPF</c> and <c>POCKET.SPF</c> are POCKET.</summary>
    public static string PlainName(string name)
    {
        name = name.ToUpperInvariant();
        name = name.StartsWith("_N_", StringComparison.Ordinal) ? name[3..] : name;
        return name.EndsWith("_SPF", StringComparison.Ordinal)
            || name.EndsWith(MainEnding, StringComparison.Ordinal)
            || name.EndsWith(".SPF", StringComparison.Ordinal)
            || name.EndsWith(".MPF", StringComparison.Ordinal)
            ? name[..^4]
            : name;
    }

    private void AddUnit(string name, int first, int end)
    {
        var unit = new FlowUnit(this, name, first, end);
        _units.Add(unit);
        if (name.Length > 0)
        {
            _named.TryAdd(_syntax == NcSyntax.Siemens ? PlainName(name) : name, unit);
        }
    }

    /// <summary>The name of the program that begins at a place of a block; empty at the marked start or end of the tape; null for anything
    /// else.</summary>
    public static string? HeadingOf(ReadOnlySpan<byte> text, int at, NcSyntax syntax)
    {
        if (at >= text.Length)
        {
            return null;
        }

        if (text[at] == '%')
        {
            return syntax == NcSyntax.Siemens ? NcText.Decode(text[(at + 1)..]).Trim().ToUpperInvariant() : "";
        }

        if (LanguageSpelling.Of(syntax) is { } language)
        {
            return language.ProgramAt(text, at);
        }

        if (syntax == NcSyntax.Iso)
        {
            return BlockHead.ProgramAt(text, at).Name;
        }

        if (syntax == NcSyntax.Siemens || (text[at] | 0x20) != 'o' || BlockHead.NumberAt(text, at + 1) is not { Length: > 0 } number)
        {
            return null;
        }

        return OWordHead.Read(text, at).Keyword.Length > 0 ? null : NumberName(number.Value);
    }
}
