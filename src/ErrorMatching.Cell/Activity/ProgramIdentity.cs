using ErrorMatching.Nc;

namespace ErrorMatching.Cell;

/// <summary>All that a control may call a program: its file, and what is at its head (<c>O0240</c>, <c>%_N_P100_MPF</c>,
/// <c>BEGIN PGM P100</c>), as the control's dialect states.</summary>
/// <param name="file">The name of its file at the machine.</param>
/// <param name="naming">By what the control names its programs.</param>
/// <param name="heads">The names at its head, or at the heads of all programs of its file.</param>
/// <param name="isUnsure">True if the control may call it by a name that is not known here: it names programs by their heads, and a content
/// has none or could not be read.</param>
public sealed class ProgramIdentity(
    string file, ProgramNaming naming = ProgramNaming.ByFile, IReadOnlyList<string>? heads = null, bool isUnsure = false)
{
    /// <summary>The name of its file.</summary>
    public string File => file;

    /// <summary>By what the control names it.</summary>
    public ProgramNaming Naming => naming;

    /// <summary>The names at its head; none if the control names programs by their files alone.</summary>
    public IReadOnlyList<string> Heads { get; } = naming == ProgramNaming.ByFile ? [] : heads ?? [];

    private IEnumerable<string> Names => Heads.Prepend(file);

    /// <summary>True if the control means this program by a name that it reports, or may: a name that cannot be compared may be any
    /// program's.</summary>
    /// <param name="reported">The name, possibly with folders.</param>
    public bool MayBe(string reported)
    {
        ArgumentNullException.ThrowIfNull(reported);
        if (!ActiveProgram.CanBeCompared(reported) || Names.Any(n => ActiveProgram.IsSame(reported, n)))
            return true;
        var number = naming == ProgramNaming.ByHead ? ActiveProgram.NumberOf(reported) : "";
        return number.Length > 0
            && (Names.Any(n => ActiveProgram.NumberOf(n) == number) || (isUnsure && ActiveProgram.NumberOf(file).Length == 0));
    }

    /// <summary>The name at its head where that is not the name of its file, although the file's name says what the control must call it;
    /// null if they agree, or if the file may have any name.</summary>
    /// <remarks>By heads, a file has a name of its own unless it is a program's number: FINISH.NC may contain O0240, and O2001.NC must
    /// not.</remarks>
    public string? OtherHead =>
        Heads.Count > 0 && !Heads.Any(IsNameOfFile) && (naming == ProgramNaming.ByBoth || HasNumber) ? Heads[0] : null;

    /// <summary>A name by which the control could mean this program or another one; null if there is none.</summary>
    /// <param name="other">The other program of the same machine.</param>
    public string? SharedWith(ProgramIdentity other)
    {
        ArgumentNullException.ThrowIfNull(other);
        return naming == ProgramNaming.ByFile
            ? (string.Equals(file, other.File, StringComparison.OrdinalIgnoreCase) ? file : null)
            : Heads.Append(file).FirstOrDefault(n => other.Names.Any(o => AreOne(n, o)));
    }

    private bool HasNumber => ActiveProgram.NumberOf(file).Length > 0;

    private bool IsNameOfFile(string head) =>
        AreOne(head, file) || ActiveProgram.IsSame(ActiveProgram.WithoutEnding(head), ActiveProgram.WithoutEnding(file));

    private bool AreOne(string one, string other) =>
        ActiveProgram.IsSame(one, other)
        || (naming == ProgramNaming.ByHead
            && ActiveProgram.NumberOf(one) is { Length: > 0 } number && number == ActiveProgram.NumberOf(other));
}
