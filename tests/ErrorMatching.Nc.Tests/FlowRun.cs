using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>Runs a program as the interpreter does and writes down the blocks whose words were acted on,
/// with the computed values of X.</summary>
internal sealed class FlowRun
{
    private readonly List<string> _trace = [];

    private FlowRun(NcFlow flow) => Flow = flow;

    public NcFlow Flow { get; }

    /// <summary>Each block as its N number or its line, <c>=</c> and the value of a computed X behind it.</summary>
    public string Trace => string.Join(' ', _trace);

    public Refusal? Refusal => Flow.Refusal;

    public static FlowRun Of(NcSyntax syntax, string text, FlowSettings? settings = null)
    {
        var run = new FlowRun(new(NcProgram.FromText(text), DialectOf(syntax), settings));
        run.Run(syntax);
        return run;
    }

    public static NcDialect DialectOf(NcSyntax syntax) =>
        syntax switch { NcSyntax.Iso => NcDialects.FanucMill, NcSyntax.LinuxCnc => NcDialects.LinuxCnc, _ => NcDialects.Siemens840D };

    public static FlowSettings Library(params (string Name, string Text)[] programs) =>
        new() { Library = name => programs.FirstOrDefault(p => p.Name == name) is { Text: { } text } ? NcProgram.FromText(text) : null };

    /// <summary>The value of a numbered variable when the program has ended.</summary>
    public string Number(int number) => Flow.Variables.Read(VariablePlace.Numbered(number), out _).ToString();

    public string Named(string name) => Flow.Variables.Read(VariablePlace.Named(name), out _).ToString();

    private void Run(NcSyntax syntax)
    {
        for (var i = Flow.First; ;)
        {
            FlowAction action;
            if (i >= Flow.Program.BlockCount)
            {
                action = Flow.AtEnd();
            }
            else
            {
                var block = Flow.Program[i];
                var text = Flow.Program.BytesOf(block);
                action = FlowTrigger.Concerns(text, DialectOf(syntax)) ? Flow.ExecuteStatements(i) : FlowAction.Words;
                if (action == FlowAction.Words)
                {
                    var moves = Record(block);
                    var concerns = FlowTrigger.Concerns(text, DialectOf(syntax)) || (moves && Flow.HasModalCall);
                    action = concerns ? Flow.ExecuteCalls(i, moves) : FlowAction.Words;
                }
            }

            if (action == FlowAction.Stop)
            {
                return;
            }

            i = action == FlowAction.Words ? i + 1 : Flow.Next;
        }
    }

    // True if the block moves an axis.
    private bool Record(NcBlock block)
    {
        var (name, value, moves, isMacro) = (Flow.Program.NumberOf(block), "", false, false);
        foreach (var token in Flow.Program.Tokens(block))
        {
            isMacro |= token is { Letter: (byte)'G', Number.Digits: 65 or 66 or 67 };
            if (token.Letter != 'X' || token.Kind is not (NcTokenKind.Word or NcTokenKind.ExpressionWord))
            {
                continue;
            }

            moves = !isMacro;
            if (token.Kind == NcTokenKind.ExpressionWord)
            {
                var start = token.ValueStart == token.Start ? token.Start + 1 : token.ValueStart;
                value = Flow.TryValue(block.Index, start, token.End - start, 3, out var x) ? "=" + x : "=?";
            }
        }

        if (Flow.Program.BytesOf(block).Trim(" \t"u8).Length > 0 && Flow.Program.BytesOf(block)[0] is not ((byte)';' or (byte)'('))
        {
            _trace.Add((name.Length > 0 ? name : string.Create(CultureInfo.InvariantCulture, $"{block.Line}")) + value);
        }

        return moves;
    }
}
