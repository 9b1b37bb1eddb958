using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>A file that a PLC or control rewrites every few seconds.</summary>
/// <param name="File">The file.</param>
/// <param name="MaxAge">An older file says nothing: its writer has stopped.</param>
internal sealed record StateFileSettings(string File, TimeSpan MaxAge) : StateSettings
{
    private const double UsualAge = 10;

    /// <inheritdoc/>
    public override string Address => File;

    /// <inheritdoc/>
    public override string? LocalFile => File;

    public static StateFileSettings Read(JsonItem item, CellPaths paths) =>
        new(paths.Of(item["file"]), TimeSpan.FromSeconds(item.Find("maxAgeS")?.Number ?? UsualAge));

    internal override MachineStateSource Open(TimeProvider clock) => new StateFile(this, clock);
}
