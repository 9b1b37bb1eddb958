using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Collects the curves of a DXF file.</summary>
/// <param name="groups">The file, for errors.</param>
/// <param name="notes">Receives what is passed over.</param>
internal sealed class DxfPen(DxfGroups groups, DxfNotes notes) : DrawingPen
{
    private DxfEntity? _entity;

    /// <inheritdoc/>
    protected override string Entity => _entity!.Label;

    /// <summary>Draws an entity.</summary>
    /// <param name="entity">The entity.</param>
    /// <param name="shapes">Its pieces.</param>
    /// <param name="layer">Its layer, or that of the INSERT that it comes from.</param>
    /// <param name="map">From its block to the drawing in millimeters.</param>
    public void Draw(DxfEntity entity, IReadOnlyList<DrawnShape> shapes, string layer, in PlaneMap map)
    {
        (_entity, Layer) = (entity, layer);
        foreach (var shape in shapes)
        {
            shape.Draw(map, this);
        }
    }

    /// <inheritdoc/>
    public override InputException Fail(string code, string problem) =>
        groups.FailAt(code, _entity!.Place, $"{_entity.Label}: {problem}");

    /// <inheritdoc/>
    protected override void NoLength() => notes.Count(DxfNote.NoLength, _entity!);
}
