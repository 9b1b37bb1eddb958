using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Checks the inserted comment line: a line of its own that does nothing.</summary>
internal sealed class MarkerCheck(ProofTask task, ProofFindings findings, string? marker)
{
    /// <summary>The line of a marker that was not requested or not found: no block is behind it.</summary>
    private const int None = int.MaxValue;

    /// <summary>The line of the marker in the result, which is also the first block of the original behind it;
    /// <see cref="int.MaxValue"/> if no marker was requested or found.</summary>
    public int Find()
    {
        var expected = task.Before.Program.BlockCount + (marker is null ? 0 : 1);
        if (task.After.Program.BlockCount != expected)
        {
            findings.Fail($"The result has {task.After.Program.BlockCount} lines, expected {expected}.");
            return None;
        }

        if (marker is null)
        {
            return None;
        }

        if (LineOf(task.After.Program, Encoding.UTF8.GetBytes(marker)) is >= 0 and var line)
        {
            CheckMarker(line);
            return line;
        }

        findings.Fail("The marker comment is not in the result.");
        return None;
    }

    // The first line that consists of the text alone; -1 if there is none.
    private static int LineOf(NcProgram program, ReadOnlySpan<byte> text)
    {
        var bytes = program.Bytes.Span;
        for (var from = 0; bytes[from..].IndexOf(text) is >= 0 and var offset; from += offset + 1)
        {
            var line = program.BlockAt(from + offset);
            if (program.BytesOf(program[line]).SequenceEqual(text))
            {
                return line;
            }
        }

        return -1;
    }

    // The marker is a comment only and has the same line end as its neighbor line.
    private void CheckMarker(int line)
    {
        var program = task.After.Program;
        var onlyComment = true;
        foreach (var token in program.Tokens(program[line]))
        {
            onlyComment &= token.Kind is NcTokenKind.Comment or NcTokenKind.Space;
        }

        var beside = line > 0 ? line - 1 : line + 1;
        if (!onlyComment || (beside < program.BlockCount && !LineEnd(program, line).SequenceEqual(LineEnd(program, beside))))
        {
            findings.Fail("The marker is not a plain comment line.");
        }
    }

    private static ReadOnlySpan<byte> LineEnd(NcProgram program, int line) =>
        program.Bytes.Span[program[line].End..(program[line].Start + program[line].FullLength)];
}
