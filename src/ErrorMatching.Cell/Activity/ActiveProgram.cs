using System.Text.RegularExpressions;

namespace ErrorMatching.Cell;

/// <summary>Compares the name by which a control reports a program with the name of the program's file. In doubt they are the same, for
/// then the file is left alone.</summary>
internal static partial class ActiveProgram
{
    /// <summary>True if both may name the same program: folders, upper and lower case, a missing ending, and leading zeros of a program's
    /// number make no difference.</summary>
    /// <param name="reported">The name that the control reports, possibly with folders.</param>
    /// <param name="file">The name of the file.</param>
    public static bool IsSame(string reported, string file)
    {
        var (one, other) = (Plain(reported), Plain(file));
        var (bareOne, bareOther) = (Bare(one), Bare(other));
        return one.Equals(other, StringComparison.OrdinalIgnoreCase)
            || ((bareOne.Length == one.Length || bareOther.Length == other.Length) && AreSame(bareOne, bareOther));
    }

    private static bool AreSame(string one, string other) =>
        one.Equals(other, StringComparison.OrdinalIgnoreCase)
        || (NumberOf(one) is { Length: > 0 } number && number == NumberOf(other));

    // A control may report program O0100 as 100.
    private static string NumberOf(string name) => Number().Match(name) is { Success: true } m ? m.Groups["number"].Value : "";

    // The last part of a path. Some controls store P100.MPF as _N_P100_MPF.
    private static string Plain(string name)
    {
        var last = name.Trim().Trim('"').Split(['/', '\\', ':'])[^1].Trim();
        return Internal().Match(last) is { Success: true } m ? $"{m.Groups["name"].Value}.{m.Groups["ending"].Value}" : last;
    }

    private static string Bare(string name) => name.LastIndexOf('.') is > 0 and var dot ? name[..dot] : name;

    [GeneratedRegex(@"\A[oO]?0*(?<number>[0-9]+)\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Number();

    [GeneratedRegex(@"\A_[nN]_(?<name>.+)_(?<ending>[A-Za-z]{3})\z", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Internal();
}
