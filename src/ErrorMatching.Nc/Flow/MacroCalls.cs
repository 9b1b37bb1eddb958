namespace ErrorMatching.Nc;

/// <summary>Calls by number of ISO controls and LinuxCNC: M98, M97, G65, G66, and their returns.</summary>
internal sealed class MacroCalls(
    NcDialect dialect,
    CallStack calls,
    FlowReport report,
    FlowMemory memory,
    FlowCourse course,
    FlowLibrary library,
    IsoWords words,
    ModalCalls modalCalls)
{
    // Local variables of the letters A to Z; 0 if a letter is not an argument (Fanuc, argument specification I).
    private static ReadOnlySpan<byte> LocalOfLetter =>
        [1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];

    // M98 P100, M98 <BORE>, and from a block of it on: M98 P100 H20, M98 H20
    public FlowAction CallNumber(int block, NcValue program)
    {
        var from = NcValue.Vacant;
        foreach (var (letter, value) in words.Collected)
        {
            from = letter == dialect.SequenceLetter && letter != 0 ? value : from;
        }

        if (!from.IsVacant && program.IsVacant && words.ProgramName is null)
        {
            return CallLocal(block, from);
        }

        if (!TryProgram(block, program, isLocal: false, out var number, out var passes))
        {
            return FlowAction.Stop;
        }

        if (passes == 0)
        {
            return FlowAction.Continue;
        }

        if (UnitOf(NameOf(program, number)) is not { } unit)
        {
            return report.Missing(block, NameOf(program, number));
        }

        var first = unit.First;
        if (!from.IsVacant)
        {
            if (!memory.TryCount(block, from, "the block at which the call begins", out var sequence))
            {
                return FlowAction.Stop;
            }

            first = unit.Index.FindNumber(unit, unit.First - 1, sequence, backward: false);
            if (first < 0)
            {
                var message = FormattableString.Invariant($"the call goes to block N{sequence}, which the called program does not have.");
                return report.Refuse(NcRefusalCodes.MissingLabel, block, message);
            }
        }

        return course.Enter(new() { Unit = unit, First = first, Caller = block, Passes = passes });
    }

    // M97 P100: the blocks of this program from N100 on.
    public FlowAction CallLocal(int block, NcValue program)
    {
        if (!TryProgram(block, program, isLocal: true, out var number, out var passes))
        {
            return FlowAction.Stop;
        }

        if (passes == 0)
        {
            return FlowAction.Continue;
        }

        var target = calls.Unit.Index.FindNumber(calls.Unit, block, number);
        if (target < 0)
        {
            var message = FormattableString.Invariant($"the call goes to block N{number}, which does not exist in this program.");
            return report.Refuse(NcRefusalCodes.MissingLabel, block, message);
        }

        // If the number is unique, searching for it from the found block returns that block.
        if (calls.Unit.Index.FindNumber(calls.Unit, target, number) != target)
        {
            var message = FormattableString.Invariant($"the call goes to block N{number}, which stands more than once in this program.");
            return report.Refuse(NcRefusalCodes.BlockAmbiguous, block, message);
        }

        return course.Enter(new() { Unit = calls.Unit, First = target, Caller = block, Passes = passes });
    }

    public FlowAction CallMacro(int block, int at, bool modal)
    {
        var program = NcValue.Vacant;
        foreach (var (letter, value) in words.Collected)
        {
            program = letter == 'P' ? value : program;
        }

        if (!TryProgram(block, program, isLocal: false, out var number, out var passes))
        {
            return FlowAction.Stop;
        }

        if (UnitOf(NameOf(program, number)) is not { } unit)
        {
            return report.Missing(block, NameOf(program, number));
        }

        var arguments = Arguments(at);
        if (!modal)
        {
            return course.Enter(new() { Unit = unit, First = unit.First, Caller = block, Passes = passes, Arguments = arguments });
        }

        return modalCalls.Begin(block, unit, passes, arguments);
    }

    public FlowAction ReturnTo(int block, NcValue program)
    {
        var number = -1L;
        if (!program.IsVacant && !memory.TryCount(block, program, "the block to return to", out number))
        {
            return FlowAction.Stop;
        }

        if (calls.Frames.Count > 1)
        {
            return course.Return(block, number);
        }

        if (number >= 0)
        {
            return course.JumpToNumber(block, number);
        }

        report.Note("endless-program", block, "M99 in the main program begins it again; one pass is read.");
        return course.Ended();
    }

    // Number and repetitions of a call. M98 P51002 is the older form of M98 P1002 L5.
    private bool TryProgram(int block, NcValue program, bool isLocal, out long number, out long passes)
    {
        (number, passes) = (0, 1);
        var isNamed = program.IsVacant && !isLocal && words.ProgramName is not null;
        if (program.IsVacant && !isNamed)
        {
            if (PathOf(calls.Program.BytesOf(calls.Program[block])) is { } path)
            {
                report.Refuse(NcRefusalCodes.MissingProgram, block,
                    $"the program {path} is called by a path of the machine, which does not exist here: what it does is not known. Put its "
                        + "file beside this one and call it by its number or name, or put its blocks in the place of the call.");
                return false;
            }

            report.Refuse(NcRefusalCodes.BadExpression, block, $"the call names no {(isLocal ? "block" : "program")}: P is missing.");
            return false;
        }

        if (!isNamed && !memory.TryCount(block, program, "the number of the called program", out number))
        {
            return false;
        }

        var hasCount = false;
        foreach (var (letter, value) in words.Collected)
        {
            if (letter == 'L' && !value.IsVacant)
            {
                hasCount = true;
                if (!memory.TryCount(block, value, "the number of repetitions", out passes))
                {
                    return false;
                }
            }
        }

        if (dialect.RepeatsInNumber && !isLocal && !hasCount && number > 9999 && UnitOf(FlowIndex.NumberName(number)) is null)
        {
            (passes, number) = (number / 10_000, number % 10_000);
        }

        // In LinuxCNC, L0 calls nothing.
        if (passes < (dialect.Syntax == NcSyntax.LinuxCnc ? 0 : 1) || number < 0)
        {
            report.Refuse(NcRefusalCodes.BadExpression, block,
                "the call has a number of repetitions, or of a program, that is not positive.");
        }

        return report.Refusal is null;
    }

    // What stands between angle brackets, quotes or parentheses and has the marks of a path; null if there is none.
    private static string? PathOf(ReadOnlySpan<byte> text)
    {
        for (var at = 0; at < text.Length; at++)
        {
            var closes = text[at] switch { (byte)'<' => (byte)'>', (byte)'"' => (byte)'"', (byte)'(' => (byte)')', _ => (byte)0 };
            if (closes == 0)
            {
                continue;
            }

            var length = text[(at + 1)..].IndexOf(closes);
            var inside = text.Slice(at + 1, Math.Max(0, length));
            if (inside.IndexOfAny("/\\"u8) >= 0 && inside.IndexOf((byte)' ') < 0)
            {
                return NcText.Decode(inside[..Math.Min(inside.Length, MostOfPath)]);
            }

            at += Math.Max(0, length) + 1;
        }

        return null;
    }

    private const int MostOfPath = 80;

    private string NameOf(NcValue program, long number) =>
        program.IsVacant ? words.ProgramName ?? "" : FlowIndex.NumberName(number);

    private FlowUnit? UnitOf(string name) => calls.Unit.Index.Unit(name)
        ?? (library.Find(dialect.Syntax == NcSyntax.LinuxCnc ? name[1..].TrimStart('0') : name) is { } index
            ? index.Unit(name) ?? index.Main : null);

    // Assigns letters to local variables. A second I, J, K belongs to the next three variables (argument specification II).
    private List<(VariablePlace, NcValue)> Arguments(int at)
    {
        var (arguments, set, last) = (new List<(VariablePlace, NcValue)>(), 0, 0);
        foreach (var (letter, value) in words.Collected.Skip(at))
        {
            var local = letter is >= (byte)'A' and <= (byte)'Z' ? LocalOfLetter[letter - 'A'] : 0;
            if (letter is (byte)'I' or (byte)'J' or (byte)'K')
            {
                set += local <= last ? 1 : 0;
                last = local;
                local += 3 * set;
            }

            if (local is > 0 and <= 33)
            {
                arguments.Add((VariablePlace.Numbered(local), value));
            }
        }

        return arguments;
    }
}
