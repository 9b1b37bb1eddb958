namespace ErrorMatching.Cell;

/// <summary>A path leads to something other than a plain file: a link, a folder, a pipe, a socket or a device.</summary>
/// <param name="path">Its path.</param>
/// <param name="defect">What it is, as returned by <see cref="PlainFile.Defect"/>.</param>
internal sealed class NotPlainFileException(string path, string defect) : IOException($"{path} is no plain file: {defect}")
{
    /// <summary>What it is.</summary>
    public string Defect => defect;
}
