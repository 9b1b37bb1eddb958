namespace ErrorMatching.Cell;

/// <summary>A folder or network share.</summary>
/// <param name="Folder">The folder. It must exist, so that an unmounted share is not mistaken for an empty one.</param>
internal sealed record FolderSettings(string Folder) : TransportSettings
{
    /// <inheritdoc/>
    public override string Address => Folder;

    /// <inheritdoc/>
    public override string? LocalFolder => Folder;

    /// <inheritdoc/>
    public override bool NeedsPassword => false;

    internal override bool IsSamePlace(TransportSettings other) =>
        other is FolderSettings { Folder: var there } && (CellPaths.IsInside(Folder, there) || CellPaths.IsInside(there, Folder));

    internal override IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit) =>
        new FolderTransport(machine, Folder, limit);
}
