namespace ErrorMatching.Nc;

/// <summary>Branches on values that only the machine knows (a probe that touched nothing), if one way only stops the run. Everything
/// executed after them took the other way, so no guess is needed.</summary>
internal sealed class FlowAlarms(NcSyntax syntax, CallStack calls, FlowReport report, FlowMemory memory)
{
    private const string ConditionalStop = "conditional-stop";

    /// <summary>IF [..] THEN #3000=..</summary>
    public bool OnlyRaisesAlarm(int block, ReadOnlySpan<byte> text, int at)
    {
        at = BehindSpaces(text, at);
        if (!BlockHead.Stands(text, at, "THEN"u8))
        {
            return false;
        }

        at = BehindSpaces(text, at + 4);
        return at < text.Length && text[at] == '#' && BlockHead.NumberAt(text, at + 1).Value == IsoWords.AlarmVariable && NoteStop(block);
    }

    /// <summary>IF .. with only messages, an alarm and M30 up to its ENDIF.</summary>
    public bool OnlyStops(FlowStatement branch, ReadOnlySpan<byte> condition)
    {
        if (syntax != NcSyntax.Siemens || branch.Kind != FlowKind.If || branch.Branch is not { Kind: FlowKind.EndIf } end)
        {
            return false;
        }

        var ends = false;
        for (var block = branch.Block + 1; block < end.Block; block++)
        {
            var text = calls.Program.BytesOf(calls.Program[block]);
            var head = BlockHead.Read(text, syntax);
            var at = head.At;
            var word = text.Slice(at, BlockHead.NameLength(text, at));
            ends = IsWord(word, "M30"u8) || IsWord(word, "M2"u8) || IsWord(word, "M02"u8);
            if (head.IsSkip || (!ends && !IsWord(word, "SETAL"u8) && !IsWord(word, "MSG"u8) && !IsWord(word, "STOPRE"u8)))
            {
                return false;
            }
        }

        var reader = memory.ReaderAt(condition, branch.At);
        var value = reader.Expression();
        return ends && reader.Error is null && value.IsUnknown && NoteStop(branch.Block);
    }

    /// <summary>FN 9: IF .. GOTO LBL of a part that only stops up to its end.</summary>
    /// <param name="label">The block of the label.</param>
    /// <param name="branch">The block that goes there.</param>
    public bool OnlyStopsFrom(int label, int branch)
    {
        for (var block = label + 1; block < calls.Program.BlockCount; block++)
        {
            var text = calls.Program.BytesOf(calls.Program[block]);
            var head = BlockHead.Read(text, syntax);
            var line = text[Math.Min(head.At, text.Length)..];
            var comment = line.IndexOf((byte)';');
            var words = (comment < 0 ? line : line[..comment]).Trim(" \t\r\n"u8);
            if (!head.IsSkip && (IsWord(words, "M30"u8) || IsWord(words, "M2"u8) || IsWord(words, "M02"u8)))
            {
                return NoteStop(branch);
            }

            if (head.IsSkip || (words.Length > 0 && !IsWord(words, "STOP"u8)))
            {
                return false;
            }
        }

        return false;
    }

    private bool NoteStop(int block)
    {
        // Once per program: a probing program has one at every point.
        block = report.Notes.FirstOrDefault(n => n.Code == ConditionalStop)?.Block ?? block;
        report.Note(
            ConditionalStop,
            block,
            "Whether the program stops here with an alarm is known to the machine only; what is shown is what it does where it goes on.");
        return true;
    }

    private static int BehindSpaces(ReadOnlySpan<byte> text, int at)
    {
        while (at < text.Length && text[at] is (byte)' ' or (byte)'\t')
        {
            at++;
        }

        return at;
    }

    private static bool IsWord(ReadOnlySpan<byte> text, ReadOnlySpan<byte> word) => System.Text.Ascii.EqualsIgnoreCase(text, word);
}
