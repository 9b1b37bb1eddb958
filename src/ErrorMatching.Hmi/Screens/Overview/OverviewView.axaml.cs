using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>The cell at a glance.</summary>
internal sealed partial class OverviewView : UserControl
{
    public OverviewView() => InitializeComponent();

    private void OnTile(object? sender, RoutedEventArgs e)
    {
        if (DataContext is OverviewViewModel piece
            && (sender as Control)?.DataContext switch
            {
                WaitingTile { IsMeasured: true } measured => measured.Id,
                SlotTile { IsPiece: true } cut => cut.Correction,
                _ => null
            } is { } id)
        {
            piece.LookAtPiece(id);
        }
        else if (DataContext is OverviewViewModel overview && (sender as Control)?.DataContext is { } tile
            && (tile is WaitingTile waiting ? waiting.Id : (tile as SlotTile)?.Correction) is { } correction)
        {
            overview.Look(correction);
        }
    }
}
