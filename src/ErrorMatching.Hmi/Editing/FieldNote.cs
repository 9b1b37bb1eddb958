using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>What is wrong with a field, below it. Nearly always nothing is, and then nothing is made: a screen has dozens of fields.</summary>
public sealed class FieldNote : Decorator
{
    /// <summary>Identifies <see cref="Field"/>.</summary>
    public static readonly StyledProperty<EditField?> FieldProperty = AvaloniaProperty.Register<FieldNote, EditField?>(nameof(Field));

    /// <summary>Identifies <see cref="IsWrong"/>.</summary>
    public static readonly StyledProperty<bool> IsWrongProperty = AvaloniaProperty.Register<FieldNote, bool>(nameof(IsWrong));

    /// <summary>The field.</summary>
    public EditField? Field
    {
        get => GetValue(FieldProperty);
        set => SetValue(FieldProperty, value);
    }

    /// <summary>True while something is wrong with it.</summary>
    public bool IsWrong
    {
        get => GetValue(IsWrongProperty);
        set => SetValue(IsWrongProperty, value);
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if ((change.Property == IsWrongProperty || change.Property == FieldProperty) && (IsWrong || Child is not null))
        {
            Child ??= new NoteFieldView();
            Child.DataContext = Field;
        }
    }
}
