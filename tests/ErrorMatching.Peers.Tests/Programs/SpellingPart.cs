using System.Text;

namespace ErrorMatching.Peers.Tests;

/// <summary>The same blocks as no two post-processors write them.</summary>
internal sealed class SpellingPart(ProgramDraft draft, RandomNumbers random, MotionPart motions)
    : ProgramPart(draft, random)
{
    public void WriteSpelling()
    {
        if (Chance(0.15))
        {
            Line(Any(
                "(a comment G1 X5)",
                "; a comment G1 X5",
                "",
                "   ",
                "(MSG, hello)",
                $"/N{Draft.Lines + 1} G1 X900 ; deleted or not",
                "( two ) ( comments )"));
            if (Draft.Text[^2] == 't')
            {
                Restate();
            }

            return;
        }

        var before = Draft.Text.Length;
        motions.WriteMotion();
        var plain = Draft.Text.ToString(before, Draft.Text.Length - before - 1);
        Draft.Text.Length = before;
        Draft.Text.Append(Respell(plain)).Append('\n');
    }

    private string Respell(string block)
    {
        var text = new StringBuilder();
        var words = block.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        for (var i = 0; i < words.Length; i++)
        {
            var word = i == 0 ? words[i] : Respelled(words[i]);
            text.Append(Chance(0.3) ? char.ToLowerInvariant(word[0]) + word[1..] : word);
            text.Append(i == 0 ? " " : Any("", " ", "  ", "\t", "(c)"));
        }

        return text + Any("", "", "", " ", "; end", " (end)");
    }

    // Numbers as people write them; a space may stand anywhere in them.
    private string Respelled(string word)
    {
        var (letter, number) = (word[..1], word[1..]);
        if (letter is "G" or "N" or "P")
        {
            return letter + (Chance(0.1) ? " " : "") + number;
        }

        if (number.StartsWith("0.", StringComparison.Ordinal) && Chance(0.5))
        {
            number = number[1..];
        }
        else if (number.StartsWith("-0.", StringComparison.Ordinal) && Chance(0.5))
        {
            number = "-" + number[2..];
        }

        if (number.Contains('.', StringComparison.Ordinal))
        {
            number += Any("", "", "0", "000");
        }
        else
        {
            number += Any("", ".", ".0");
        }

        number = number[0] is not '-' && Chance(0.2) ? "+" + number : number;
        return letter + (Chance(0.1) ? " " : "") + (Chance(0.1) && number.Length > 3 ? number.Insert(2, " ") : number);
    }
}
