using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Appends a probing program to another program and checks both again: the first must not change its motion, the second must move
/// as it does alone.</summary>
internal sealed class ProbingMerge(ProbingProgram probing, string file, string? cutsIn)
{
    private const string LeavesBehind = "it leaves a rotation, a shift, another work offset, a compensation or another mode behind in "
        + "which probing would go elsewhere. End it before M30.";

    public ReadOnlyMemory<byte> After(ReadOnlyMemory<byte> bytes, string definitions, string body)
    {
        var first = NcProgram.Read(bytes, probing.Dialect.Syntax);
        var (block, end) = EndOf(first);
        var lineEnd = bytes.Span.IndexOf("\r\n"u8) >= 0 ? "\r\n" : "\n";
        var merged = new MemoryStream();
        var start = BehindHead(first);
        merged.Write(bytes.Span[..start]);
        merged.Write(Encoding.UTF8.GetBytes(definitions.ReplaceLineEndings(lineEnd)));

        // Only the end itself is removed from the block that ends the program. A spindle stop or coolant word stays.
        merged.Write(bytes.Span[start..end.Start]);
        var rest = first[block].End is var blockEnd ? bytes.Span[end.End..Math.Max(end.End, blockEnd)] : default;
        merged.Write(rest);
        merged.Write(Encoding.UTF8.GetBytes(lineEnd + body.ReplaceLineEndings(lineEnd)));
        merged.Write(bytes.Span[(block + 1 < first.BlockCount ? first[block + 1].Start : bytes.Length)..]);
        var result = merged.ToArray();
        Check(first, result);
        return result;
    }

    private (int Block, NcToken End) EndOf(NcProgram program)
    {
        var ends = new List<(int, NcToken)>();
        for (var i = 0; i < program.BlockCount; i++)
        {
            foreach (var token in program.Tokens(program[i]))
            {
                if (token is { Kind: NcTokenKind.Word, Letter: (byte)'M' }
                    && probing.Dialect.FunctionOf((int)Math.Clamp(token.Number.Value, -1, int.MaxValue)) == FunctionRole.ProgramEnd)
                {
                    ends.Add((i, token));
                }
            }
        }

        return ends.Count switch
        {
            1 => ends[0],
            0 => throw Fail("it has no M2 or M30 that ends it. Add one where probing is to begin."),
            _ =>
                throw Fail(
                    $"it has {ends.Count} places that end it, the first in {program.NameOf(program[ends[0].Item1])}. Leave the one where "
                        + $"probing is to begin."),
        };
    }

    // Definitions follow names, comments and the program's own definitions.
    private static int BehindHead(NcProgram program)
    {
        if (program.Syntax != NcSyntax.Siemens)
        {
            return 0;
        }

        for (var i = 0; i < program.BlockCount; i++)
        {
            var text = program.TextOf(program[i]).TrimStart();
            if (text.Length > 0
                && text[0] is not ('%' or ';')
                && !text.StartsWith("DEF ", StringComparison.OrdinalIgnoreCase)
                && !text.StartsWith("PROC ", StringComparison.OrdinalIgnoreCase)
                && !text.StartsWith("EXTERN ", StringComparison.OrdinalIgnoreCase))
            {
                return program[i].Start;
            }
        }

        return program.Bytes.Length;
    }

    private void Check(NcProgram first, byte[] merged)
    {
        var dialect = probing.Dialect;
        var alone = NcInterpreter.Run(first, dialect);
        var touched = NcInterpreter.Run(NcProgram.Read(probing.Bytes, dialect.Syntax), dialect);
        var both = NcInterpreter.Run(NcProgram.Read(merged, dialect.Syntax), dialect);
        if ((alone.Refusal ?? both.Refusal) is { } refusal)
        {
            throw Fail("it cannot be followed to its end: " + refusal.Message);
        }

        if (alone.Problems is [var unknown, ..])
        {
            var cuts = cutsIn is null || cutsIn == dialect.Name
                ? ""
                : $" (toolpath.dialect is {cutsIn}, measuring.dialect is {dialect.Name})";
            throw Fail(
                $"{first.NameOf(first[unknown.Block])} cannot be read as {dialect.Name}, for which the probing program is: "
                    + $"{unknown.Message} One program runs on one control{cuts}. Give --after a program for {dialect.Name}, or change "
                    + $"measuring.dialect to that of the program.");
        }

        if (OffsetChanges(alone))
        {
            throw Fail(LeavesBehind);
        }

        if (both.Motions.Length != alone.Motions.Length + touched.Motions.Length)
        {
            throw Fail(
                "behind it the probing program would not make the motions that it makes alone: does it end with a cycle, a loop or a "
                    + "call that is still active?");
        }

        for (var i = 0; i < both.Motions.Length; i++)
        {
            var (now, before) = (both.Motions[i], i < alone.Motions.Length ? alone.Motions[i] : touched.Motions[i - alone.Motions.Length]);
            var stated = ~before.UnknownEnd;
            if (now.Kind != before.Kind
                || !Same(now.End, before.End, stated)
                || (now.Flags & ~before.Flags & ~Unknown(now)) != MotionFlags.None)
            {
                throw Fail(i < alone.Motions.Length
                    ? "together with the definitions of the probing program it would move otherwise than alone."
                    : LeavesBehind);
            }
        }
    }

    // After a call with unknown motion, and after another tool length, a move starts at another place than the previous one ended.
    private static MotionFlags Unknown(in NcMotion motion) =>
        motion.UnknownStart != AxisSet.None ? MotionFlags.StartsElsewhere : MotionFlags.None;

    // Probing uses the work offset of the cuts, so it must not change after the last cut.
    private static bool OffsetChanges(NcPath path)
    {
        var cut = path.Motions.Length - 1;
        while (cut >= 0 && !path.Motions[cut].IsCut)
        {
            cut--;
        }

        if (cut < 0)
        {
            return false;
        }

        var (cuts, leaves) = (path.Frames[path.Motions[cut].Frame], path.Frames[^1]);
        return leaves.UnknownShift == AxisSet.None
            && (cuts.WorkOffset, cuts.WorkOffsetNumber, cuts.Shift) != (leaves.WorkOffset, leaves.WorkOffsetNumber, leaves.Shift);
    }

    private static bool Same(Point3 a, Point3 b, AxisSet axes) =>
        ((axes & AxisSet.X) == AxisSet.None || a.X == b.X)
            && ((axes & AxisSet.Y) == AxisSet.None || a.Y == b.Y)
            && ((axes & AxisSet.Z) == AxisSet.None || a.Z == b.Z);

    private InputException Fail(string problem) => InputException.At("not-mergeable", file, problem);
}
