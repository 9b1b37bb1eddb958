using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>The statements of a file that belong to structures: branches, loops and subroutines, each linked to the others of its
/// structure.</summary>
internal sealed class FlowStatements(NcSyntax syntax)
{
    private const int DeepestStructure = 100;

    private readonly Dictionary<int, FlowStatement> _statements = [];
    private readonly Dictionary<string, FlowStatement> _subs = new(StringComparer.Ordinal);
    private readonly Stack<(string Label, FlowStatement Begin, FlowStatement Last)> _open = new();

    /// <summary>The statement at a block; null if there is none.</summary>
    public FlowStatement? At(int block) => _statements.GetValueOrDefault(block);

    /// <summary>The definition of a LinuxCNC subroutine; null if the file has none.</summary>
    public FlowStatement? Sub(string label) => _subs.GetValueOrDefault(label);

    /// <summary>Adds the next block of the file, if it is part of a structure.</summary>
    /// <param name="text">Its bytes.</param>
    /// <param name="at">Start of its first statement.</param>
    /// <param name="block">Its position.</param>
    public void Add(ReadOnlySpan<byte> text, int at, int block)
    {
        switch (syntax)
        {
            case NcSyntax.LinuxCnc when (text[at] | 0x20) == 'o':
                AddOWord(text, at, block);
                break;
            case NcSyntax.Siemens:
                AddSiemens(text, at, block);
                break;
            case NcSyntax.Iso:
                AddMacro(text, at, block);
                break;
        }
    }

    private void AddMacro(ReadOnlySpan<byte> text, int at, int block)
    {
        if (BlockHead.Stands(text, at, "WHILE"u8))
        {
            var place = at + 5 + BlockSpaces(text, at + 5);
            var end = BehindBracket(text, place);
            end += BlockSpaces(text, end);
            if (BlockHead.Stands(text, end, "DO"u8))
            {
                Begin(NumberText(text, end + 2), new(FlowKind.While, block, place));
            }
            else
            {
                _statements[block] = new(FlowKind.While, block, place);
            }
        }
        else if (BlockHead.Stands(text, at, "DO"u8) && BlockHead.NumberAt(text, at + 2).Length > 0)
        {
            Begin(NumberText(text, at + 2), new(FlowKind.Loop, block, at));
        }
        else if (BlockHead.Stands(text, at, "END"u8) && BlockHead.NumberAt(text, at + 3).Length > 0)
        {
            var label = NumberText(text, at + 3);
            var isWhile = _open.FirstOrDefault(o => o.Label == label).Begin is { Kind: FlowKind.While };
            Finish(label, new(isWhile ? FlowKind.EndWhile : FlowKind.EndLoop, block, at), isWhile ? FlowKind.While : FlowKind.Loop);
        }
    }

    private void AddOWord(ReadOnlySpan<byte> text, int at, int block)
    {
        var (label, _, keyword, end) = OWordHead.Read(text, at);
        switch (keyword)
        {
            case "SUB":
                var sub = new FlowStatement(FlowKind.Sub, block, end);
                _subs.TryAdd(label, sub);
                Begin(label, sub);
                break;
            case "ENDSUB": Finish(label, new(FlowKind.EndSub, block, end), FlowKind.Sub); break;
            case "CALL": _statements[block] = new(FlowKind.Call, block, at); break;
            case "RETURN": _statements[block] = new(FlowKind.Return, block, end); break;
            case "IF": Begin(label, new(FlowKind.If, block, end)); break;
            case "ELSEIF": Branch(label, new(FlowKind.ElseIf, block, end)); break;
            case "ELSE": Branch(label, new(FlowKind.Else, block, end)); break;
            case "ENDIF": Finish(label, new(FlowKind.EndIf, block, end), FlowKind.If); break;
            case "DO": Begin(label, new(FlowKind.Do, block, end)); break;
            case "WHILE" when _open.Any(o => o.Label == label && o.Begin.Kind == FlowKind.Do):
                Finish(label, new(FlowKind.Until, block, end), FlowKind.Do);
                break;
            case "WHILE": Begin(label, new(FlowKind.While, block, end)); break;
            case "ENDWHILE": Finish(label, new(FlowKind.EndWhile, block, end), FlowKind.While); break;
            case "REPEAT": Begin(label, new(FlowKind.Repeat, block, end)); break;
            case "ENDREPEAT": Finish(label, new(FlowKind.EndRepeat, block, end), FlowKind.Repeat); break;
            case "BREAK" or "CONTINUE":
                _statements[block] = new(keyword[0] == 'B' ? FlowKind.Break : FlowKind.Continue, block, end)
                {
                    Start = _open.FirstOrDefault(o => o.Label == label).Begin
                };
                break;
        }
    }

    private void AddSiemens(ReadOnlySpan<byte> text, int at, int block)
    {
        var length = BlockHead.NameLength(text, at);
        if (length is < 2 or > 8)
        {
            return;
        }

        var end = at + length;
        switch (NcText.Decode(text.Slice(at, length)).ToUpperInvariant())
        {
            case "IF" when !HasWord(text, end, "GOTO"u8): Begin("IF", new(FlowKind.If, block, end)); break;
            case "ELSE": Branch("IF", new(FlowKind.Else, block, end)); break;
            case "ENDIF": Finish("IF", new(FlowKind.EndIf, block, end), FlowKind.If); break;
            case "WHILE": Begin("WHILE", new(FlowKind.While, block, end)); break;
            case "ENDWHILE": Finish("WHILE", new(FlowKind.EndWhile, block, end), FlowKind.While); break;
            case "FOR": Begin("FOR", new(FlowKind.For, block, end)); break;
            case "ENDFOR": Finish("FOR", new(FlowKind.EndFor, block, end), FlowKind.For); break;
            case "LOOP": Begin("LOOP", new(FlowKind.Loop, block, end)); break;
            case "ENDLOOP": Finish("LOOP", new(FlowKind.EndLoop, block, end), FlowKind.Loop); break;
            case "REPEAT" when end + BlockSpaces(text, end) is var rest && (rest >= text.Length || text[rest] == ';'):
                Begin("REPEAT", new(FlowKind.Do, block, end));
                break;
            case "UNTIL": Finish("REPEAT", new(FlowKind.Until, block, end), FlowKind.Do); break;
        }
    }

    // A word outside texts and comments.
    private static bool HasWord(ReadOnlySpan<byte> text, int at, ReadOnlySpan<byte> word)
    {
        for (var quoted = false; at < text.Length; at++)
        {
            quoted ^= text[at] == '"';
            if (!quoted && text[at] == ';')
            {
                return false;
            }

            if (!quoted && BlockHead.Stands(text, at, word) && !SyntaxBytes.IsLetter(text[at - 1]))
            {
                return true;
            }
        }

        return false;
    }

    private static int BehindBracket(ReadOnlySpan<byte> text, int at)
    {
        for (var depth = 0; at < text.Length; at++)
        {
            depth += text[at] == '[' ? 1 : text[at] == ']' ? -1 : 0;
            if (depth <= 0)
            {
                return at + 1;
            }
        }

        return at;
    }

    private static int BlockSpaces(ReadOnlySpan<byte> text, int at)
    {
        var end = at;
        while (end < text.Length && text[end] is (byte)' ' or (byte)'\t')
        {
            end++;
        }

        return end - at;
    }

    private static string NumberText(ReadOnlySpan<byte> text, int at) =>
        BlockHead.NumberAt(text, at).Value.ToString(CultureInfo.InvariantCulture);

    private void Begin(string label, FlowStatement statement)
    {
        statement.Start = statement;
        _statements[statement.Block] = statement;
        if (_open.Count < DeepestStructure)
        {
            _open.Push((label, statement, statement));
        }
    }

    private void Branch(string label, FlowStatement statement)
    {
        _statements[statement.Block] = statement;
        if (CloseUpTo(label, FlowKind.If) is { } open)
        {
            statement.Start = open.Begin;
            open.Last.Branch = statement;
            _open.Push((label, open.Begin, statement));
        }
    }

    private void Finish(string label, FlowStatement statement, FlowKind begin)
    {
        _statements[statement.Block] = statement;
        if (CloseUpTo(label, begin) is { } open)
        {
            statement.Start = open.Begin;
            open.Last.Branch = statement;
            open.Begin.End = statement;
        }
    }

    // Closes the innermost open structure of a label; structures inside it that were never closed stay without an end. Null if none is
    // open.
    private (FlowStatement Begin, FlowStatement Last)? CloseUpTo(string label, FlowKind kind)
    {
        if (!_open.Any(o => o.Label == label && o.Begin.Kind == kind))
        {
            return null;
        }

        while (true)
        {
            var open = _open.Pop();
            if (open.Label == label && open.Begin.Kind == kind)
            {
                return (open.Begin, open.Last);
            }
        }
    }
}
