"""forming"""
