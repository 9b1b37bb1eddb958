using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>Shows tokens as short text: <c>X=10</c> a word, <c>X=a10</c> and <c>X=i10</c> AC and IC, <c>X?R1</c> a computed word,
/// <c>,R=5</c> a corner word; other kinds by a sign in front.</summary>
internal static class Spelled
{
    public static NcSyntax Of(string syntax) => Enum.Parse<NcSyntax>(syntax);

    public static string Tokens(string text, NcSyntax syntax, int block = 0) => Tokens(NcProgram.FromText(text, syntax), block);

    public static string Tokens(NcProgram program, int block = 0)
    {
        var shown = new List<string>();
        foreach (var token in program.Tokens(program[block]))
        {
            if (token.Kind != NcTokenKind.Space)
            {
                shown.Add(Show(program, token));
            }
        }

        return string.Join(" | ", shown);
    }

    private static string Show(NcProgram program, NcToken token)
    {
        var text = Encoding.Latin1.GetString(program.Bytes.Span.Slice(token.Start, token.Length));
        var value = Encoding.Latin1.GetString(program.Bytes.Span.Slice(token.ValueStart, token.ValueLength));
        var distance = token.Distance switch { WordDistance.Absolute => "a", WordDistance.Incremental => "i", _ => "" };
        return token.Kind switch
        {
            NcTokenKind.Word => $"{NcAddress.NameOf(token.Letter)}={distance}{token.Number}",
            NcTokenKind.ExpressionWord => $"{NcAddress.NameOf(token.Letter)}?{distance}{value}",
            NcTokenKind.CommaWord when token.Number == default && value.AsSpan().ContainsAnyExcept("+-0. ") =>
                $",{(char)token.Letter}?{value}",
            NcTokenKind.CommaWord => $",{(char)token.Letter}={token.Number}",
            NcTokenKind.Assignment => ":= " + text,
            NcTokenKind.Keyword => "# " + text,
            NcTokenKind.Expression => "[] " + text,
            NcTokenKind.Comment => "c " + text,
            NcTokenKind.Percent => "% " + text,
            NcTokenKind.BlockSkip => "/ " + text,
            NcTokenKind.Label => "@ " + text,
            _ => "! " + text,
        };
    }
}
