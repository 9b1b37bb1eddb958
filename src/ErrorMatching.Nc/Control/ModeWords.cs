namespace ErrorMatching.Nc;

/// <summary>Says whether the words of a block change nothing but modes, the tool's place and variables: all that two runs are compared
/// by.</summary>
internal sealed class ModeWords(NcControl control)
{
    // Lines, arcs, waits, and letters of what does not move. D, H, T and what the dialect does not know can change more, and so can each
    // of these letters where a dialect has it as another axis.
    private static readonly uint Letters = BlockWords.LinearAxes | BlockWords.CenterWords
        | "RNFSPLOQ".Aggregate(0u, (bits, letter) => bits | BlockWords.Bit(letter));

    /// <summary>True if all letters of a block are of this kind whose words are plain, with no code but G0 or G1.</summary>
    public bool AreAllLetters() => (control.Words.Present & (~Letters | control.Values.OtherAxes)) == 0;

    /// <summary>True if all words of the block are of this kind.</summary>
    public bool AreAll()
    {
        var (words, values) = (control.Words, control.Values);
        var given = words.Present | words.Computed;
        if (words.Invalid.Length > 0 || words.Semicolon.Length > 1 || words.IsPolar || words.HasPolarEnd || words.Corner != 0
            || ((words.Present | (words.Computed & ~(BlockWords.Bit('G') | BlockWords.Bit('M')))) & ~Letters) != 0
            || (words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0
            || (given & (values.UnknownLetters | values.OtherAxes | values.ToolCalls | values.Lengths | values.LengthNumbers)) != 0)
        {
            return false;
        }

        foreach (var code in words.Codes)
        {
            // Without an axis, all of them return, those that turn too.
            var meaning = control.Dialect.MeaningOf(code);
            if (!IsMode(meaning) || (meaning == NcMeaning.ReferenceReturn && (given & BlockWords.LinearAxes) == 0))
            {
                return false;
            }
        }

        foreach (var function in words.Functions)
        {
            if (function == BlockCodes.ToolChange || control.Dialect.FunctionOf(function) is not (FunctionRole.Harmless
                or FunctionRole.Call or FunctionRole.LocalCall or FunctionRole.Return or FunctionRole.ProgramEnd))
            {
                return false;
            }
        }

        foreach (var statement in words.Statements)
        {
            if (!IsMode(statement))
            {
                return false;
            }
        }

        return true;
    }

    private bool IsMode(NcMeaning meaning) => meaning switch
    {
        NcMeaning.Harmless or NcMeaning.Dwell or NcMeaning.Rapid or NcMeaning.Line or NcMeaning.ArcClockwise
            or NcMeaning.ArcCounterClockwise or NcMeaning.PlaneXY or NcMeaning.PlaneZX or NcMeaning.PlaneYZ or NcMeaning.Inch
            or NcMeaning.Metric or NcMeaning.Absolute or NcMeaning.Incremental or NcMeaning.AbsoluteCenters
            or NcMeaning.IncrementalCenters or NcMeaning.ReferenceReturn or NcMeaning.ReferenceReturnOfAxes
            or NcMeaning.MachineCoordinates or NcMeaning.SuppressFrames or NcMeaning.CycleOff or NcMeaning.RetractToInitial
            or NcMeaning.RetractToR or NcMeaning.Call or NcMeaning.InverseTimeFeed or NcMeaning.FeedPerMinute
            or NcMeaning.FeedPerRevolution => true,
        NcMeaning.CompensationOff => control.State.Compensation == MotionFlags.None,
        _ => false,
    };

    // An assignment to a variable of the program, a label, and a word that is a mode.
    private bool IsMode(NcToken statement)
    {
        var name = control.Run.NameOf(statement);
        return statement.Kind switch
        {
            NcTokenKind.Keyword => control.Run.Text.Bytes.Span[statement.End - 1] == ':' || IsMode(control.Dialect.MeaningOf(name)),
            NcTokenKind.Assignment when control.Dialect.Ways.AssignmentsAreWords =>
                control.Run.IsVariable(name)
                    || (name.Length > 1 && (name[0] | 0x20) == 'r' && name[1..].IndexOfAnyExceptInRange((byte)'0', (byte)'9') < 0),
            NcTokenKind.Assignment => true,
            _ => false,
        };
    }
}
