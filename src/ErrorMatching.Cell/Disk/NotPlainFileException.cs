namespace ErrorMatching.Cell;

/// <summary>Something has the name of a file and is none: a link, a folder, a pipe, a socket or a device.</summary>
/// <param name="path">Its path.</param>
/// <param name="defect">What it is, as <see cref="PlainFile.Defect"/> says it.</param>
internal sealed class NotPlainFileException(string path, string defect) : IOException($"{path} is no plain file: {defect}")
{
    /// <summary>What it is.</summary>
    public string Defect => defect;
}
