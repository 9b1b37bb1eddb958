using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The program that was written.</summary>
/// <param name="File">Its file.</param>
/// <param name="Sha256">SHA-256 of its bytes.</param>
/// <param name="ChangedBlocks">Number of blocks that differ from the original.</param>
/// <param name="ChangedWords">Number of words changed or inserted.</param>
/// <param name="Blocks">The blocks that differ, side by side.</param>
public sealed record ReportProgram(string File, string Sha256, int ChangedBlocks, int ChangedWords, IReadOnlyList<ReportBlock> Blocks)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("file", File);
        w.Text("sha256", Sha256);
        w.Count("changedBlocks", ChangedBlocks);
        w.Count("changedWords", ChangedWords);
        w.List("blocks", Blocks, b => b.Write(w));
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ReportProgram Read(ReportReader r) => new(
        r.Text("file"), r.Text("sha256"), r.Count("changedBlocks"), r.Count("changedWords"), r.List("blocks", ReportBlock.Read));
}
