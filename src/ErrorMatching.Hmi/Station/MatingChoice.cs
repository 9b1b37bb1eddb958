using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A mating to choose.</summary>
/// <param name="Name">Its display name: the name of the first of the cell's jobs with its file.</param>
/// <param name="Jobs">The cell's jobs with its file: those of parts and those of counterparts.</param>
internal sealed record MatingChoice(string Name, IReadOnlyList<string> Jobs)
{
    /// <summary>The matings of a cell, in the order of its configuration.</summary>
    /// <param name="settings">The configuration.</param>
    public static IReadOnlyList<MatingChoice> Of(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return [
            .. settings.Jobs.Where(j => !j.IsFreeform)
                .GroupBy(j => j.File, StringComparer.Ordinal)
                .Select(g => new MatingChoice(g.First().Name, [.. g.Select(j => j.Name)]))];
    }
}
