using System.ComponentModel;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>The signing dialog.</summary>
internal sealed partial class SigningView : UserControl
{
    // Less than this is rounding.
    private const double Least = 1;

    public SigningView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);
        TakeFocus();
        Facts.ScrollChanged += (_, _) => See();
        See();
        if (DataContext is SigningViewModel signing)
        {
            signing.PropertyChanged += OnSigning;
        }
    }

    /// <summary>Focuses its first field, unless it has the focus already.</summary>
    public void TakeFocus()
    {
        if (!IsKeyboardFocusWithin)
        {
            (DataContext is SigningViewModel { NeedsReason: true } ? ReasonBox : PasswordBox).Focus();
        }
    }

    /// <inheritdoc/>
    protected override void OnUnloaded(RoutedEventArgs e)
    {
        if (DataContext is SigningViewModel signing)
        {
            signing.PropertyChanged -= OnSigning;
        }

        base.OnUnloaded(e);
    }

    // Not before it is loaded: keys may come before anything is drawn.
    private void See()
    {
        if (IsLoaded)
        {
            (DataContext as SigningViewModel)?.See(Facts.Offset.Y + Facts.Viewport.Height >= Facts.Extent.Height - Least);
        }
    }

    // After a failure the password is cleared and must be entered next, whichever button was tapped.
    private void OnSigning(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName is nameof(SigningViewModel.Message) && sender is SigningViewModel { Message: not null, NeedsPassword: true })
        {
            Dispatcher.UIThread.Post(() => PasswordBox.Focus(), DispatcherPriority.Background);
        }
    }

    // Enter confirms if all fields are filled in; otherwise it moves to the missing one.
    private void OnReasonKey(object? sender, KeyEventArgs e)
    {
        if (e.Key == Key.Enter && DataContext is SigningViewModel { NeedsPassword: true } signing && !signing.Confirm.CanExecute(null))
        {
            PasswordBox.Focus();
            e.Handled = true;
        }
    }
}
