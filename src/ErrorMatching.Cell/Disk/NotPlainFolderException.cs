namespace ErrorMatching.Cell;

/// <summary>The name of one of the cell's own folders belongs to a link or a file.</summary>
internal sealed class NotPlainFolderException(string path)
    : IOException($"{path} is a link or a file; it must be a folder of its own. Remove it");
