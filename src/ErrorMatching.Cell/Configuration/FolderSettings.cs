namespace ErrorMatching.Cell;

/// <summary>A folder or network share.</summary>
/// <param name="Folder">The folder; it must exist, for a share that is not mounted must not be mistaken for an empty one.</param>
public sealed record FolderSettings(string Folder) : TransportSettings;
