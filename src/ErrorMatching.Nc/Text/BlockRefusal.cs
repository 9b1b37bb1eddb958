using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Makes refusals about blocks of a program.</summary>
public static class BlockRefusal
{
    /// <summary>A refusal whose message begins with the block's name (<c>N110</c>, or <c>line 12</c> if it has no number).</summary>
    /// <param name="program">The program.</param>
    /// <param name="block">Index of the block, from 0.</param>
    /// <param name="code">One of <see cref="NcRefusalCodes"/>, or another stable identifier.</param>
    /// <param name="message">What was found there, why it cannot be used, and what to do.</param>
    public static Refusal At(NcProgram program, int block, string code, string message)
    {
        ArgumentNullException.ThrowIfNull(program);
        var name = program.NameOf(program[block]);
        return new(code, $"{name}: {message}", new() { Block = name, Line = program[block].Line });
    }
}
