using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A path that is built figure by figure.</summary>
internal sealed class SkiaStreamGeometry() : SkiaGeometry(new SKPath()), IStreamGeometryImpl
{
    public IStreamGeometryImpl Clone()
    {
        var clone = new SkiaStreamGeometry();
        clone.Replace(new SKPath(Filled), Filled == Stroked ? null : new SKPath(Stroked));
        return clone;
    }

    public IStreamGeometryContextImpl Open() => new Builder(this);

    // A second path begins with the first figure that is only stroked.
    private sealed class Builder(SkiaStreamGeometry target) : IStreamGeometryContextImpl
    {
        private readonly SKPathBuilder _all = new() { FillType = SKPathFillType.EvenOdd };
        private SKPathBuilder? _filled;
        private bool _isFilled = true;

        public void SetFillRule(FillRule fillRule)
        {
            _all.FillType = fillRule.ToSkia();
            if (_filled is not null)
            {
                _filled.FillType = _all.FillType;
            }
        }

        public void BeginFigure(Point startPoint, bool isFilled = true)
        {
            _isFilled = isFilled;
            if (!isFilled && _filled is null)
            {
                using var before = _all.Snapshot();
                _filled = new SKPathBuilder(before) { FillType = _all.FillType };
            }

            Each(b => b.MoveTo(startPoint.ToSkia()));
        }

        public void LineTo(Point point, bool isStroked = true)
        {
            // The most frequent one, without a closure.
            _all.LineTo(point.ToSkia());
            if (_isFilled)
            {
                _filled?.LineTo(point.ToSkia());
            }
        }

        public void CubicBezierTo(Point c1, Point c2, Point end, bool isStroked = true) =>
            Each(b => b.CubicTo(c1.ToSkia(), c2.ToSkia(), end.ToSkia()));

        public void QuadraticBezierTo(Point c, Point end, bool isStroked = true) => Each(b => b.QuadTo(c.ToSkia(), end.ToSkia()));

        public void ArcTo(
            Point point, Size size, double rotationAngle, bool isLargeArc, SweepDirection sweepDirection, bool isStroked = true) =>
            Each(b => b.ArcTo(
                new SKPoint((float)size.Width, (float)size.Height),
                (float)rotationAngle,
                isLargeArc ? SKPathArcSize.Large : SKPathArcSize.Small,
                sweepDirection == SweepDirection.Clockwise ? SKPathDirection.Clockwise : SKPathDirection.CounterClockwise,
                point.ToSkia()));

        public void EndFigure(bool isClosed)
        {
            if (isClosed)
            {
                Each(b => b.Close());
            }
        }

        public void Dispose()
        {
            target.Replace(_filled?.Detach() ?? _all.Snapshot(), _filled is null ? null : _all.Snapshot());
            _filled?.Dispose();
            _all.Dispose();
        }

        private void Each(Action<SKPathBuilder> act)
        {
            act(_all);
            if (_isFilled && _filled is not null)
            {
                act(_filled);
            }
        }
    }
}
