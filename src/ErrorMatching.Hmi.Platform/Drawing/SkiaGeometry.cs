using System.Diagnostics.CodeAnalysis;
using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A path.</summary>
internal class SkiaGeometry : IGeometryImpl
{
    private SKPath _filled;
    private SKPath _stroked;
    private Rect? _bounds;

    /// <summary>Takes a path over.</summary>
    /// <param name="filled">What is filled.</param>
    /// <param name="stroked">What a pen follows; null if it is the same.</param>
    public SkiaGeometry(SKPath filled, SKPath? stroked = null) => (_filled, _stroked) = (filled, stroked ?? filled);

    /// <summary>What is filled.</summary>
    public SKPath Filled => _filled;

    /// <summary>What a pen follows.</summary>
    public SKPath Stroked => _stroked;

    public Rect Bounds => _bounds ??= _stroked.IsEmpty ? default : _stroked.ComputeTightBounds().ToAvalonia();

    public double ContourLength
    {
        get
        {
            using var measure = new SKPathMeasure(_stroked, false, 1);
            double sum = measure.Length;
            while (measure.NextContour())
            {
                sum += measure.Length;
            }

            return sum;
        }
    }

    public static SkiaGeometry Of(Action<SKPathBuilder> build, FillRule rule = FillRule.EvenOdd)
    {
        using var builder = new SKPathBuilder { FillType = rule.ToSkia() };
        build(builder);
        return new(builder.Detach());
    }

    public static SkiaGeometry Line(Point from, Point to) => Of(b =>
    {
        b.MoveTo(from.ToSkia());
        b.LineTo(to.ToSkia());
    });

    public static SkiaGeometry Group(FillRule rule, IEnumerable<IGeometryImpl> children)
    {
        var parts = children.OfType<SkiaGeometry>().ToArray();
        var filled = Of(b => Array.ForEach(parts, p => b.AddPath(p._filled, SKPathAddMode.Append)), rule);
        return parts.All(p => p._filled == p._stroked)
            ? filled
            : new(filled._filled, Of(b => Array.ForEach(parts, p => b.AddPath(p._stroked, SKPathAddMode.Append)), rule)._filled);
    }

    /// <summary>Combines the areas of two geometries.</summary>
    public static SkiaGeometry Combined(GeometryCombineMode mode, IGeometryImpl first, IGeometryImpl second) => new(
        ((SkiaGeometry)first)._filled.Op(((SkiaGeometry)second)._filled, mode switch
        {
            GeometryCombineMode.Union => SKPathOp.Union,
            GeometryCombineMode.Intersect => SKPathOp.Intersect,
            GeometryCombineMode.Xor => SKPathOp.Xor,
            _ => SKPathOp.Difference,
        }) ?? new SKPath());

    public Rect GetRenderBounds(IPen? pen)
    {
        if (pen is not { Thickness: > 0 } || _stroked.IsEmpty)
        {
            return Bounds;
        }

        // An outline could be computed exactly, which takes longer than drawing it. This is never too small.
        using var paint = new SKPaint();
        PenPaint.Set(paint, pen);
        return paint.GetFastBounds(Bounds.ToSkia(), out var reached) ? reached.ToAvalonia() : Bounds;
    }

    public bool FillContains(Point point) => _filled.Contains((float)point.X, (float)point.Y);

    public bool StrokeContains(IPen? pen, Point point)
    {
        if (pen is not { Thickness: > 0 })
        {
            return false;
        }

        using var outline = Outline(pen);
        return outline.Contains((float)point.X, (float)point.Y);
    }

    public IGeometryImpl? Intersect(IGeometryImpl geometry) => Combined(GeometryCombineMode.Intersect, this, geometry);

    public IGeometryImpl GetWidenedGeometry(IPen pen) => new SkiaGeometry(Outline(pen));

    public ITransformedGeometryImpl WithTransform(Matrix transform) => new Transformed(this, transform);

    public bool TryGetPointAtDistance(double distance, out Point point) => TryGetPointAndTangentAtDistance(distance, out point, out _);

    public bool TryGetPointAndTangentAtDistance(double distance, out Point point, out Point tangent)
    {
        using var measure = new SKPathMeasure(_stroked, false, 1);
        do
        {
            if (distance <= measure.Length
                && measure.GetPositionAndTangent((float)distance, out var at, out var direction))
            {
                (point, tangent) = (new(at.X, at.Y), new(direction.X, direction.Y));
                return true;
            }

            distance -= measure.Length;
        }
        while (measure.NextContour());
        point = tangent = default;
        return false;
    }

    public bool TryGetSegment(
        double startDistance, double stopDistance, bool startOnBeginFigure, [NotNullWhen(true)] out IGeometryImpl? segmentGeometry)
    {
        using var measure = new SKPathMeasure(_stroked, false, 1);
        using var builder = new SKPathBuilder();
        var (at, isFound) = (0.0, false);
        do
        {
            var (from, to) = (Math.Max(startDistance, at), Math.Min(stopDistance, at + measure.Length));
            isFound |= from < to && measure.GetSegment((float)(from - at), (float)(to - at), builder, startOnBeginFigure || !isFound);
            at += measure.Length;
        }
        while (measure.NextContour());
        segmentGeometry = new SkiaGeometry(builder.Detach());
        return isFound;
    }

    /// <summary>Replaces the paths.</summary>
    protected void Replace(SKPath filled, SKPath? stroked)
    {
        (_filled, _stroked) = (filled, stroked ?? filled);
        _bounds = null;
    }

    private SKPath Outline(IPen pen)
    {
        using var paint = new SKPaint();
        PenPaint.Set(paint, pen);
        return paint.GetFillPath(_stroked) ?? new SKPath();
    }

    private static SKPath Moved(SKPath path, Matrix transform)
    {
        var moved = new SKPath(path);
        var matrix = transform.ToSkia();
        moved.Transform(in matrix);
        return moved;
    }

    private sealed class Transformed(SkiaGeometry source, Matrix transform) : SkiaGeometry(
        Moved(source._filled, transform),
        source._filled == source._stroked ? null : Moved(source._stroked, transform)), ITransformedGeometryImpl
    {
        public IGeometryImpl SourceGeometry => source;

        public Matrix Transform => transform;
    }
}
