using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Draws the entities of a file, with those of inserted blocks in their places.</summary>
/// <param name="file">The file.</param>
/// <param name="notes">Receives what is passed over.</param>
/// <param name="pen">Receives the curves.</param>
internal sealed class DxfBlocks(DxfFile file, DxfNotes notes, DxfPen pen)
{
    private readonly DxfGeometry _geometry = new(file, notes);
    private int _visits;

    /// <summary>Draws everything.</summary>
    /// <param name="map">From the numbers of the drawing to millimeters.</param>
    public void Draw(in PlaneMap map) => Draw(file.Drawing, null, map, 0);

    private void Draw(DxfBlock block, string? insertLayer, in PlaneMap map, int depth)
    {
        if (!block.IsUsed)
        {
            block.IsUsed = true;
            foreach (var (kind, count) in block.Others)
            {
                notes.Kind(kind, count);
            }
        }

        foreach (var entity in block.Entities)
        {
            Visit(entity);
            if (entity.IsPaper || entity.IsInvisible)
            {
                notes.Count(entity.IsPaper ? DxfNote.Paper : DxfNote.Invisible, entity);
                continue;
            }

            // What is on layer 0 in a block is on the layer of its INSERT.
            var (layer, isHidden, isFrozen) = file.Layer(insertLayer is not null && entity.Layer == "0" ? insertLayer : entity.Layer);
            var isInsert = entity.Kind == "INSERT";
            if (isInsert ? isFrozen : isHidden)
            {
                notes.Hidden(layer);
                continue;
            }

            if (isInsert)
            {
                Insert(entity, layer, map, depth);
            }
            else
            {
                pen.Draw(entity, entity.Shapes ??= _geometry.Read(entity), layer, map);
            }
        }
    }

    private void Insert(DxfEntity entity, string layer, in PlaneMap map, int depth)
    {
        var insert = entity.Insert ??= _geometry.ReadInsert(entity);
        var block = insert.Block;
        if (block.IsExternal)
        {
            notes.Count(DxfNote.External, entity);
            return;
        }

        if (block.IsOpen || depth >= DxfLimits.MaxDepth)
        {
            throw file.Groups.FailAt("bad-block", entity.Place, block.IsOpen
                ? $"{entity.Label}: block {DrawingLimits.Quote(block.Name)} contains itself; blocks of other blocks are expected"
                : string.Create(
                    CultureInfo.InvariantCulture,
                    $"{entity.Label}: blocks are nested more than {DxfLimits.MaxDepth} deep; fewer levels are expected"));
        }

        block.IsOpen = true;
        for (var row = 0; row < insert.Rows; row++)
        {
            for (var column = 0; column < insert.Columns; column++)
            {
                Visit(entity);
                Draw(block, layer, map.After(insert.At(column, row)), depth + 1);
            }
        }

        block.IsOpen = false;
    }

    private void Visit(DxfEntity entity)
    {
        if (++_visits > DxfLimits.MaxVisits)
        {
            throw file.Groups.FailAt("too-large", entity.Place, string.Create(
                CultureInfo.InvariantCulture,
                $"{entity.Label}: more than {DxfLimits.MaxVisits} entities with those of inserted blocks; fewer are expected"));
        }
    }
}
