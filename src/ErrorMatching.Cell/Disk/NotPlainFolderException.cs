namespace ErrorMatching.Cell;

/// <summary>Something has the name of a folder of the cell's own and is a link or a file.</summary>
/// <param name="path">Its path.</param>
internal sealed class NotPlainFolderException(string path)
    : IOException($"{path} is a link or a file; it must be a folder of its own. Remove it");
