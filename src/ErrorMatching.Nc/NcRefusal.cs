namespace ErrorMatching.Nc;

/// <summary>A program, selector or wish that can be read but must not be used: a normal outcome, described in a setter's words.</summary>
/// <param name="Code">A stable identifier for scripts, such as <c>block-not-found</c>; see <see cref="NcRefusalCodes"/>.</param>
/// <param name="Block">The block as the setter knows it (<c>N110</c> or <c>line 12</c>); empty if no block is the cause.</param>
/// <param name="Line">Line number from 1; 0 if no block is the cause.</param>
/// <param name="Message">What was found, why it cannot be used, and what to do.</param>
public sealed record NcRefusal(string Code, string Block, int Line, string Message)
{
    internal static NcRefusal At(NcProgram program, int block, string code, string message) =>
        new(code, program.NameOf(program[block]), program[block].Line, $"{program.NameOf(program[block])}: {message}");
}
