using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// The proof has its own eyes: it takes the wish from the rewriter and nothing else.
/// What both use is how a program is read (its text, its motions) and lines and circles;
/// an error in what one of them concludes from that is no error of the other.
/// </summary>
public sealed class ProofApartTests
{
    private static readonly string[] Wish = ["DisplacementWish", "ElementWish", "PointWish"];

    // The rewriter's geometry of an element; the proof builds its own.
    private static readonly string[] Geometry = ["Carrier"];

    [Fact]
    public void The_proof_takes_nothing_from_the_rewriter_but_the_wish()
    {
        var own = TypesIn("Rewriting").Concat(TypesIn("Wishes")).Except(Wish).Concat(Geometry).ToArray();
        Assert.Contains("Fillet", own);
        Assert.Contains("Obstacles", own);
        Assert.Contains("PathWithoutPoints", own);
        // The members of an enumeration may have the names of types.
        foreach (var file in FilesIn("Proof").Where(f => !Code(f).Contains("enum ", StringComparison.Ordinal)))
        {
            Assert.Empty(Words(Code(file)).Intersect(own).Select(t => $"{Path.GetFileName(file)} uses {t}"));
        }
    }

    [Fact]
    public void The_rewriter_takes_nothing_from_the_proof()
    {
        var own = TypesIn("Proof");
        Assert.Contains("Prover", own);
        foreach (var file in FilesIn("Rewriting").Concat(FilesIn("Wishes")))
        {
            Assert.Empty(Words(Code(file)).Intersect(own).Select(t => $"{Path.GetFileName(file)} uses {t}"));
        }
    }

    private static string[] FilesIn(string folder) => Directory.GetFiles(Repository.PathTo("src", "ErrorMatching.Nc", folder), "*.cs");

    // A file is named after its one type; a part of a type has a second name.
    private static string[] TypesIn(string folder) =>
        [.. FilesIn(folder).Select(f => Path.GetFileName(f).Split('.')[0]).Distinct(StringComparer.Ordinal)];

    // Behind a dot stands a member.
    private static HashSet<string> Words(string code) =>
        [.. Regex.Matches(code, @"(?<![.\w])[A-Z]\w*", RegexOptions.None, Timeout.InfiniteTimeSpan).Select(m => m.Value)];

    // Without comments and texts, which may name what they like.
    private static string Code(string file) => Regex.Replace(
        File.ReadAllText(file), "//[^\n]*|\"[^\"\n]*\"", "", RegexOptions.None, Timeout.InfiniteTimeSpan);
}
